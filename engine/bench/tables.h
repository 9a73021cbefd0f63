// The paper's Tables 1 and 2, measured again: tick times of every method in free space and in contact on scenes of the
// paper's sizes and larger, the time until the scene can be touched, and memory. The paper's own figures are listed
// beside them; the heads of its columns say Hz, but the figures are seconds a haptic frame.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/bench/report_table.h"
#include "engine/bench/timing.h"

namespace moltact::bench {

/// Seconds a haptic frame as the paper prints them; nothing where it prints N/A.
struct PaperFigures {
  std::optional<double> free_polygons_s, free_spheres_s, contact_polygons_s, contact_spheres_s;
};

struct TableScene {
  std::string name;         ///< "Test 1: 50 random spheres"
  std::size_t sphere_count = 0;  ///< expected, for the order and the progress bar
  std::function<std::vector<Sphere>()> makeSpheres;
  std::string paper_name;  ///< the row of the paper that it stands beside; may be empty
};

/// 50 and 150 random spheres; protein-like clusters of 2785, 3735, 13 751, 165 000 and 1 000 000; `quick`:
/// without the two largest but with 100 000.
std::vector<TableScene> madeScenes(bool quick, std::uint64_t seed);

/// The paper's figures for "Test 1", "Test 2", "5ADH", "8TIM", "1KBW"; nothing for other names.
std::optional<PaperFigures> paperFigures(const std::string& paper_name);

struct TableOptions {
  std::vector<const Method*> methods;
  double probe_A = kWaterProbe_A;
  StrokePlan plan;
  double budget_s = 0.5;           ///< of counted time a method, scene and motion
  std::size_t least_prepared = 0;  ///< methods that prepare a whole scene are left out of scenes of fewer spheres
};

struct SceneTimes {
  std::string scene;
  std::string paper_name;
  std::size_t spheres = 0;
  double scene_s = 0;                    ///< the preparation that all methods share
  std::vector<TickTimes> free, contact;  ///< a row a method made for this size, in the order of the options
};

/// The methods that are made for scenes of so many spheres (Method::most_spheres); methods that prepare a whole scene only
/// from `least_prepared` spheres on.
std::vector<const Method*> methodsForSize(const std::vector<const Method*>& methods, std::size_t spheres,
                                          std::size_t least_prepared = 0);

std::vector<SceneTimes> measureTables(const std::vector<TableScene>& scenes, const TableOptions& options,
                                      const Progress& progress);

/// A row a scene, motion and method: mean, p50, p99, p99.99, max, ratio of the mean to exact's, touching.
ReportTable tickTable(const std::vector<SceneTimes>& times);

/// A row a scene and method: time until touchable, memory, atoms modelled of loaded.
ReportTable readyTable(const std::vector<SceneTimes>& times);

/// The paper's figures and the same scenes here, in nanoseconds.
ReportTable besidePaperTable(const std::vector<SceneTimes>& times);

}  // namespace moltact::bench
