// Who is stuck: longer on a step than three quarters of the class. Pure; any thread.
#pragma once

#include <cstddef>
#include <span>

namespace moltact {

/// How long a student has been on a step, over all visits (unit: second of use).
struct StepTime {
  double spent_s = 0.0;
  bool left = false;  ///< the student has gone on to another step
};

/// Nobody is stuck before this time on a step (unit: second), or while fewer others have reached it.
inline constexpr double kStuckAfter_s = 30.0;
inline constexpr std::size_t kStuckOthers = 3;

/// Whether somebody who has been on a step for `spent_s` is stuck: at least three quarters of the others who have reached
/// the step have left it in less time. Those who are still on it have not been faster, whenever they came.
inline bool isStuck(double spent_s, std::span<const StepTime> others) {
  if (spent_s < kStuckAfter_s || others.size() < kStuckOthers) return false;
  std::size_t faster = 0;
  for (const StepTime& other : others) faster += other.left && other.spent_s < spent_s;
  return 4 * faster >= 3 * others.size();
}

}  // namespace moltact
