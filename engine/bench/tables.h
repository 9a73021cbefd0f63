// The paper's Tables 1 and 2, measured again: tick times of every method in free space and in contact, preparation time
// and memory. The scenes have the paper's sizes and larger ones. The paper's own figures are listed for comparison. Its
// column heads state Hz, but the figures are seconds per haptic frame.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/bench/report_table.h"
#include "engine/bench/timing.h"

namespace moltact::bench {

/// Seconds per haptic frame as printed in the paper; empty where it prints N/A.
struct PaperFigures {
  std::optional<double> free_polygons_s, free_spheres_s, contact_polygons_s, contact_spheres_s;
};

struct TableScene {
  std::string name;              ///< "Test 1: 50 random spheres"
  std::size_t sphere_count = 0;  ///< expected number, for the order and the progress bar
  std::function<std::vector<Sphere>()> makeSpheres;
  std::string paper_name;  ///< the corresponding row of the paper; may be empty
};

/// 50 and 150 random spheres; protein-like clusters of 2785, 3735, 13 751, 165 000 and 1 000 000. `quick` replaces the
/// two largest by one of 100 000.
std::vector<TableScene> madeScenes(bool quick, std::uint64_t seed);

/// The paper's figures for "Test 1", "Test 2", "5ADH", "8TIM", "1KBW"; empty for other names.
std::optional<PaperFigures> paperFigures(const std::string& paper_name);

struct TableOptions {
  std::vector<const Method*> methods;
  double probe_A = kWaterProbe_A;
  StrokePlan plan;
  double budget_s = 0.5;         ///< counted time per method, scene and motion
  std::size_t min_prepared = 0;  ///< smallest scene for methods that prepare the whole scene
};

struct SceneTimes {
  std::string scene;
  std::string paper_name;
  std::size_t spheres = 0;
  double scene_s = 0;                    ///< preparation common to all methods
  std::vector<TickTimes> free, contact;  ///< one element per method suitable for this size, in the order of the options
};

/// The methods suitable for this number of spheres (MethodLimits::max_spheres); methods that prepare the whole scene only
/// from `min_prepared` spheres.
std::vector<const Method*> methodsForSize(const std::vector<const Method*>& methods, std::size_t spheres,
                                          std::size_t min_prepared = 0);

std::vector<SceneTimes> measureTables(const std::vector<TableScene>& scenes, const TableOptions& options,
                                      const Progress& progress);

/// One row per scene, motion and method: mean, p50, p99, p99.99, max, ratio of the mean to exact's, fraction touching.
ReportTable tickTable(const std::vector<SceneTimes>& times);

/// One row per scene and method: preparation time, memory, modelled and loaded atoms.
ReportTable readyTable(const std::vector<SceneTimes>& times);

/// The paper's figures and those of the same scenes here, in nanoseconds.
ReportTable paperComparisonTable(const std::vector<SceneTimes>& times);

}  // namespace moltact::bench
