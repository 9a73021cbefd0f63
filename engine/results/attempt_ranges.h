// What the numbers of an attempt may be: a table by key, of what a program of ours can have written. A line with a
// number outside it is passed over and told, so that nobody downstream has to doubt one. Any thread but the haptic one.
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
inline constexpr std::size_t kMostFigures = 100, kMostCurveValues = 10'000, kMostSteps = 10'000;

}  // namespace moltact
