// Judges the methods of rendering forces between atoms by numbers, in the scenes of field_scenes.h. The loop is closed
// by a simulated device of little friction and a hand; the safety stage is left out. The result is equal in every run
// of the same build, for any number of threads. Units: angstrom, newton, millimetre, joule.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "engine/bench/energies/field_scenes.h"
#include "engine/bench/report_table.h"
#include "engine/bench/timing.h"
#include "engine/servo/safety_limits.h"

namespace moltact::bench {

/// "coupled": the contact and a virtual coupling (CoupledField). The others give the field's force at the hand, scaled, as
/// the literature does: "direct" the sum over pairs, "bounded" the same with walls bounded by asinh (PairModel), and grids of
/// 0.375 A.
inline constexpr std::array<std::string_view, 5> kFieldMethods{"coupled", "direct", "bounded", "trilinear", "tricubic"};

/// A value above its limit is a failure.
struct FieldLimits {
  double overlap_A = 0.5;                           ///< of probe and atom at the energy of zero: it is inside
  double made_J = 1e-5;                             ///< beyond what sampling a spring of the loop's stiffness can make
  double step_N = safety::kSlew_N_per_s * kTick_s;  ///< between ticks of a slow hand: what the safety stage passes
  double jitter_mm = 0.055;                         ///< of the held device: one step of its sensor
};

struct FieldResult {
  std::string scene;
  std::string_view method;
  std::size_t draw = 0;
  std::size_t ticks = 0, broken = 0;
  double overlap_A = 0, made_J = 0, step_N = 0, jitter_mm = 0;
  double returned_J = 0;  ///< made_J with what sampling can make
  double force_N = 0;     ///< greatest
};

FieldResult runFieldScene(const FieldScene& scene, std::string_view method);

/// "O", "E", "S", "J", "N": the criteria in which the result fails; empty: sound.
std::string failuresOf(const FieldResult& result, const FieldLimits& limits = {});

struct FieldMatrixOptions {
  std::uint64_t seed = 1;
  std::size_t draws = 10;
};

/// All methods in all draws of all scenes, ordered by scene, method and draw. Uses every processor.
std::vector<FieldResult> measureFieldMatrix(const FieldMatrixOptions& options, const Progress& progress);

/// One row per scene, one column per method: the failures, their greatest value and the number of draws.
ReportTable fieldMatrix(const std::vector<FieldResult>& results, const FieldLimits& limits = {});
/// The scenes and what they test.
ReportTable fieldScenesTable();
/// Markdown sentences that state the matrix's results.
std::string fieldMatrixSentences(const std::vector<FieldResult>& results, const FieldLimits& limits = {});

}  // namespace moltact::bench
