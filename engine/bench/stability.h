// Runs methods through the stability scenes and says where each one fails. On a virtual clock: the same
// figures on every run of the same build. Units: angstrom, newton, millimetre, joule.
#pragma once

#include <optional>
#include <vector>

#include "engine/bench/report_table.h"
#include "engine/bench/stability_scenes.h"
#include "engine/bench/timing.h"
#include "engine/haptics/methods.h"

namespace moltact::bench {

/// What is more than this is a failure. The figures without an Over are counted from zero.
struct StabilityLimits {
  double penetration_A = 1e-7;  ///< of the SCP into a sphere
  double step_over_N = 0.05;    ///< of the force's step from tick to tick over the true surface's
  double jitter_mm = 0.055;     ///< of the held device from peak to peak: a step of its sensor
  double energy_J = 5e-6;       ///< made by the method: a spring pressed 1 A deep holds 2.4e-3
};

struct StabilityResult {
  std::string scene;
  const Method* method = nullptr;
  std::size_t ticks = 0;
  std::size_t contact_ticks = 0;  ///< in which the right answer touches
  std::size_t tunnelled = 0;      ///< times the HIP stood free behind a wall that still holds the right SCP
  std::size_t lost =
      0;  ///< ticks without contact although the right SCP is over 0.02 A from the HIP in matter
  std::size_t stuck = 0;     ///< ticks with a pull over 0.2 A where there is nothing to touch
  std::size_t astray = 0;    ///< ticks in contact over 0.5 A from the right place
  std::size_t broken = 0;    ///< ticks whose answer is not a finite place
  double penetration_A = 0;  ///< deepest of the SCP
  double step_N = 0;         ///< greatest step of the force from tick to tick
  double step_over_N = 0;    ///< the same over the true surface's within two ticks; 0 where it has no meaning
  double jitter_mm = 0;      ///< of the held device
  double energy_J = 0;       ///< made by the method: trapezoidal work, so that sampling is not counted
  double loop_energy_J = 0;  ///< made at the device, by sampling, delay and rounding too
  double sampling_J = 0;  ///< the most that sampling, delay and rounding alone could have made in that motion
  std::optional<double> stiffest_N_per_mm;  ///< the greatest stiffness that stays stable
};

struct StabilityOptions {
  std::vector<const Method*> methods;
  LoopSettings loop;
  std::uint64_t seed = 1;
  bool stiffness = true;  ///< look for the greatest stable stiffness in every scene where something can be pressed
};

/// One method in one scene.
StabilityResult runScene(const StabilityScene& scene, const Method& method, const LoopSettings& loop);

/// The greatest stiffness (unit: N/mm, 0.02 to 20) at which pressing from here to there ends in rest, by
/// bisection to 3 %; 0 where even the least does not rest in contact. The hand is light (100 N/m, 2 N s/m),
/// and the device is struck while it is pressed.
double stiffestStable(const std::function<std::unique_ptr<Tracker>()>& make,
                      const StabilityScene::Press& press, LoopSettings loop);

/// The same for the plain wall.
double stiffestStableOnWall(const LoopSettings& loop);

/// All methods in all scenes.
std::vector<StabilityResult> measureStability(const StabilityOptions& options, const Progress& progress);

/// The letters of what failed: T tunnelling, L lost contact, H held where nothing is, P penetration, J jump
/// of force, R residual jitter, E energy made, N not finite; empty when sound.
std::string failures(const StabilityResult& result, const StabilityLimits& limits = {});

/// Scenes down, methods across, the letters in the cells.
ReportTable stabilityMatrix(const std::vector<StabilityResult>& results, const StabilityLimits& limits = {});
/// Every figure, a row a scene and method.
ReportTable stabilityFigures(const std::vector<StabilityResult>& results, const StabilityLimits& limits = {});
/// The greatest stable stiffness: scenes down, the plain wall and the methods across.
ReportTable stiffnessTable(const std::vector<StabilityResult>& results, double wall_N_per_mm);

}  // namespace moltact::bench
