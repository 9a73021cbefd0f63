// The ranges of an attempt's numbers: a table by key of the values that this program can have written. A line with a
// number outside its range is skipped and reported, so that later code need not check it. Any thread but the haptic
// one.
#pragma once

#include <cstddef>
#include <string_view>

namespace moltact {

struct AttemptRange {
  std::string_view key;
  double min = 0.0, max = 0.0;
  bool whole = false;  ///< only whole numbers
};

/// The range of a key; null for an unknown key.
const AttemptRange* attemptRange(std::string_view key);

/// Longer lists are rejected: a task's figures, a curve's values, a lesson's steps.
inline constexpr std::size_t kMaxFigures = 100, kMaxCurveValues = 10'000, kMaxSteps = 10'000;

}  // namespace moltact
