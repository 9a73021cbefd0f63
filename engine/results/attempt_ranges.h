// The ranges of the numbers of an attempt: a table by key, of the values that this program can have written. A line
// with a number outside it is skipped and reported, so that nobody downstream has to doubt one. Any thread but the
// haptic one.
#pragma once

#include <cstddef>
#include <string_view>

namespace moltact {

struct AttemptRange {
  std::string_view key;
  double least = 0.0, most = 0.0;
  bool whole = false;  ///< a whole number
};

/// The range of a key; null for one that the format does not know.
const AttemptRange* attemptRange(std::string_view key);

/// Longer lists are refused: figures of a task, values of a curve, steps of a lesson.
inline constexpr std::size_t kMaxFigures = 100, kMaxCurveValues = 10'000, kMaxSteps = 10'000;

}  // namespace moltact
