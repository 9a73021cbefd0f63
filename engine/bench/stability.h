// Runs methods through the stability scenes many times and measures fidelity and stability, in two separate tables. On
// a virtual clock: the results are equal in every run of the same build, for any number of threads. Units: angstrom,
// newton, millimetre, joule.
#pragma once

#include <string>
#include <vector>

#include "engine/bench/report_table.h"
#include "engine/bench/stability_scenes.h"
#include "engine/bench/statistics.h"
#include "engine/bench/timing.h"
#include "engine/bench/touch_thresholds.h"
#include "engine/haptics/methods.h"

namespace moltact::bench {

/// A value above its limit is a failure.
struct StabilityLimits {
  double place_A = kPlaceFelt_A;     ///< distance of the SCP from the reference
  double step_over_N = kStepFelt_N;  ///< a jump: the force steps by this much more than the reference force
  double jitter_mm = 0.055;          ///< peak-to-peak motion of the held device: one step of its sensor
  double energy_J = 1e-5;            ///< generated over a closed path; a spring pressed 1 A deep stores 2.4e-3
};

/// The result of one method in one scene and draw, a random variation of the scenes (drawnScenes). Counts are in ticks
/// unless stated otherwise.
struct StabilityResult {
  std::string scene;
  const Method* method = nullptr;
  bool changing = false;  ///< the scene's surface moves or has friction
  std::size_t draw = 0;
  std::size_t ticks = 0;
  // Fidelity:
  std::size_t contact_ticks = 0;  ///< the reference is known, and it or the method touches
  /// Of these, with the SCP farther than place_A from the reference; includes `lost` and `stuck`.
  std::size_t off = 0;
  /// Of these, without contact although the HIP is inside the molecule and the reference SCP farther than place_A from it.
  std::size_t lost = 0;
  /// Of these, with the SCP farther than place_A from the HIP although the reference does not touch.
  std::size_t stuck = 0;
  std::size_t sunk = 0;      ///< ticks, also without a known reference, with the SCP deeper than place_A in a sphere
  double penetration_A = 0;  ///< largest depth of the SCP in any tick
  // Stability:
  std::size_t tunnelled =
      0;                   ///< events: the HIP is free behind a wall that still holds the reference SCP over 0.5 A away
  std::size_t jumps = 0;   ///< steps of the force that exceed those of the reference force by more than step_over_N
  std::size_t broken = 0;  ///< the SCP is not finite
  double step_N = 0;       ///< largest step of the force between ticks
  double step_over_N = 0;  ///< largest step beyond that of the reference force within two ticks; 0 if meaningless
  double jitter_mm = 0;    ///< of the held device
  double energy_J = 0;     ///< generated over the closed path (path_energy.h)
  double loop_energy_J = 0;  ///< generated at the device, including sampling, delay and rounding
  double sampling_J = 0;     ///< upper bound for sampling, delay and rounding alone in that motion
};

struct StabilityOptions {
  std::vector<const Method*> methods;
  LoopSettings loop;
  StabilityLimits limits;
  std::uint64_t seed = 1;
  std::size_t draws = 30;
};

/// The results in scenes whose surface moves or has friction, or those in the others.
std::vector<StabilityResult> resultsWhere(const std::vector<StabilityResult>& results, bool changing);

/// Runs one method in one scene.
StabilityResult runScene(const StabilityScene& scene, const Method& method, const LoopSettings& loop,
                         const StabilityLimits& limits = {});

/// Runs all methods in all draws of all scenes, ordered by scene, method and draw. Uses every processor.
std::vector<StabilityResult> measureStability(const StabilityOptions& options, const Progress& progress);

/// The results of a method in a scene over all draws.
struct StabilityCell {
  std::string scene;
  const Method* method = nullptr;
  std::size_t draws = 0;
  MeanOf off_percent;  ///< of the ticks in contact
  // Mean number of events per 10 000 ticks of contact, and the number of draws with at least one.
  double tunnelled = 0, jumps = 0, broken = 0;
  std::size_t with_tunnel = 0, with_jump = 0, with_broken = 0, with_jitter = 0, with_energy = 0;
  double jitter_mm = 0, energy_J = 0;  ///< maximum; mean
  bool unsound() const { return with_tunnel + with_jump + with_broken + with_jitter + with_energy > 0; }
};

std::vector<StabilityCell> stabilityCells(const std::vector<StabilityResult>& results,
                                          const StabilityLimits& limits = {});

/// Fidelity: one row per scene, one column per method, the fraction of ticks that are off with its 95 % interval.
ReportTable fidelityMatrix(const std::vector<StabilityCell>& cells, const StabilityLimits& limits = {});
/// Stability: one row per scene, one column per method, events with the number of draws that had one.
ReportTable stabilityMatrix(const std::vector<StabilityCell>& cells, const StabilityLimits& limits = {});
/// One row per method: its errors over all scenes and draws.
ReportTable stabilitySummary(const std::vector<StabilityResult>& results, const StabilityLimits& limits = {});
/// All figures, one row per scene, method and draw.
ReportTable stabilityFigures(const std::vector<StabilityResult>& results);

/// The device and the loop of the scenes.
ReportTable deviceTable(const LoopSettings& loop = {});

/// Sentences that state the tables' results.
std::string stabilitySentences(const std::vector<StabilityResult>& results, const StabilityLimits& limits = {});

}  // namespace moltact::bench
