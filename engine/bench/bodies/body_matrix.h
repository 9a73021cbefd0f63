// Runs methods for a rigid body through the scenes of body_scenes.h and judges them by numbers. The result is equal in
// every run of the same build, for any number of threads. Springs of 1 N per A. Units: angstrom, newton.
#pragma once

#include <string>
#include <vector>

#include "engine/bench/bodies/body_scenes.h"
#include "engine/bench/methods/body_methods.h"
#include "engine/bench/report_table.h"
#include "engine/bench/timing.h"
#include "engine/bench/touch_thresholds.h"

namespace moltact::bench {

/// A value above its limit is a failure.
struct BodyLimits {
  double overlap_A = kPlaceFelt_A;
  double energy_NA = 1e-9;       ///< made in one tick
  double force_N = kStepFelt_N;  ///< rms error
  double jitter_N = 0.01;        ///< peak to peak, hand standing still
  double rest_A = 1e-6;          ///< motion of the body between ticks, hand standing still
};

/// The result of one method in one scene and draw.
struct BodyResult {
  std::string scene;
  const BodyMethod* method = nullptr;
  std::size_t draw = 0;
  std::size_t ticks = 0;
  std::size_t contact_ticks = 0;  ///< in which the right answer or the method touches
  double overlap_A = 0;           ///< largest of any tick
  /// Events: the body follows the hand freely, over 0.5 A from where the wall still holds it; of a method whose steps
  /// between ticks are known, ticks in which its path leads through a sphere (PathWatch).
  std::size_t tunnelled = 0;
  double energy_NA = 0;      ///< most made in one tick; 0 where the spheres move
  std::size_t unrested = 0;  ///< of the last 100 ticks with a standing hand: body in motion or not at rest
  /// Errors against RightBody (rms), where the oracle confirms the right answer and the hand has moved by less than 1 A in
  /// each of the last five ticks.
  double force_N = 0, torque_NA = 0, position_A = 0;
  std::size_t judged = 0;  ///< ticks with such an error
  double jitter_N = 0;     ///< of the last 100 ticks
  std::size_t broken = 0;  ///< answers that are not finite
};

BodyResult runBodyScene(const BodyScene& scene, const BodyMethod& method);

/// "O", "T", "E", "U", "F", "J", "N": the criteria in which the result fails; empty: sound.
std::string failuresOf(const BodyResult& result, const BodyLimits& limits = {});

struct BodyMatrixOptions {
  std::vector<const BodyMethod*> methods;
  std::uint64_t seed = 1;
  std::size_t draws = 10;
};

/// All methods in all draws of all scenes, ordered by scene, method and draw. Uses every processor.
std::vector<BodyResult> measureBodyMatrix(const BodyMatrixOptions& options, const Progress& progress);

/// One row per scene, one column per method: the failures, their greatest value and the number of draws.
ReportTable bodyMatrix(const std::vector<BodyResult>& results, const BodyLimits& limits = {});
/// All numbers, one row per scene and method: the greatest of the draws.
ReportTable bodyMatrixFigures(const std::vector<BodyResult>& results);
/// The scenes and what they test.
ReportTable bodyScenesTable();
/// Markdown sentences that state the matrix's results.
std::string bodyMatrixSentences(const std::vector<BodyResult>& results, const BodyLimits& limits = {});

}  // namespace moltact::bench
