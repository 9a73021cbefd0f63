// Leads methods through the stability scenes, many times over, and measures how true and how stable each one is: two
// questions, two tables. On a virtual clock: the same figures on every run of the same build, for any number of
// threads. Units: angstrom, newton, millimetre, joule.
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
  double place_A = kPlaceFelt_A;     ///< of the SCP from the right one: not true
  double step_over_N = kStepFelt_N;  ///< of the force's step from tick to tick over the true surface's: a jump
  double jitter_mm = 0.055;          ///< of the held device from peak to peak: a step of its sensor
  double energy_J = 1e-5;            ///< made over a closed path: a spring pressed 1 A deep holds 2.4e-3
};

/// One method in one scene, once. Counts are of ticks but where said.
struct StabilityResult {
  std::string scene;
  const Method* method = nullptr;
  std::size_t draw = 0;
  std::size_t ticks = 0;
  // How true:
  std::size_t contact_ticks = 0;  ///< in which the right answer or the method's touches
  std::size_t off = 0;            ///< of these, SCP farther than place_A from the right one; all below are off too
  std::size_t lost = 0;           ///< no contact, though the HIP in matter is held
  std::size_t stuck = 0;          ///< contact where there is nothing to touch
  std::size_t sunk = 0;           ///< SCP deeper than place_A in a sphere
  double penetration_A = 0;       ///< deepest of the SCP in any tick
  // How stable:
  std::size_t tunnelled = 0;  ///< times the HIP stood free behind a wall that still holds the right SCP over 0.5 A off
  std::size_t jumps = 0;      ///< the force steps by step_over_N more than the true surface's
  std::size_t broken = 0;     ///< the answer is not a finite place
  double step_N = 0;          ///< greatest step of the force from tick to tick
  double step_over_N = 0;     ///< greatest over the true surface's within two ticks; 0 where it has no meaning
  double jitter_mm = 0;       ///< of the held device
  double energy_J = 0;        ///< made over the closed path (path_energy.h)
  double loop_energy_J = 0;   ///< made at the device, by sampling, delay and rounding too
  double sampling_J = 0;      ///< the most that sampling, delay and rounding alone could have made in that motion
};

struct StabilityOptions {
  std::vector<const Method*> methods;
  LoopSettings loop;
  StabilityLimits limits;
  std::uint64_t seed = 1;
  std::size_t draws = 30;
};

/// One method in one scene.
StabilityResult runScene(const StabilityScene& scene, const Method& method, const LoopSettings& loop,
                         const StabilityLimits& limits = {});

/// All methods in all draws of all scenes, by scene, then method, then draw. Uses every processor.
std::vector<StabilityResult> measureStability(const StabilityOptions& options, const Progress& progress);

/// A method in a scene over all draws.
struct StabilityCell {
  std::string scene;
  const Method* method = nullptr;
  std::size_t draws = 0;
  MeanOf off_percent;  ///< of the ticks in contact
  // Events in 10 000 ticks of contact, on the mean, and in how many draws there was one.
  double tunnelled = 0, jumps = 0, broken = 0;
  std::size_t with_tunnel = 0, with_jump = 0, with_broken = 0, with_jitter = 0, with_energy = 0;
  double jitter_mm = 0, energy_J = 0;  ///< greatest; mean
  bool unsound() const { return with_tunnel + with_jump + with_broken + with_jitter + with_energy > 0; }
};

std::vector<StabilityCell> stabilityCells(const std::vector<StabilityResult>& results,
                                          const StabilityLimits& limits = {});

/// How true: scenes down, methods across, the fraction of ticks that are off with its 95 % interval.
ReportTable fidelityMatrix(const std::vector<StabilityCell>& cells, const StabilityLimits& limits = {});
/// How stable: scenes down, methods across, events with the number of draws that had one.
ReportTable stabilityMatrix(const std::vector<StabilityCell>& cells, const StabilityLimits& limits = {});
/// A row a method: its errors over all scenes and draws.
ReportTable stabilitySummary(const std::vector<StabilityResult>& results, const StabilityLimits& limits = {});
/// Every figure, a row a scene, method and draw.
ReportTable stabilityFigures(const std::vector<StabilityResult>& results);

/// The device and the loop of the scenes.
ReportTable deviceTable(const LoopSettings& loop = {});

/// Sentences that state the tables' results.
std::string stabilitySentences(const std::vector<StabilityResult>& results, const StabilityLimits& limits = {});

}  // namespace moltact::bench
