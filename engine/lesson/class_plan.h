// Divides a school lesson of 45 minutes: an opening, the steps of the core, a talk and the exit ticket. Pure functions;
// any thread but the haptic one. Unit: minute.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/lesson/lesson.h"

namespace moltact {

inline constexpr int kClassMinutes = 45;
inline constexpr int kOpeningMinutes = 4, kTalkMinutes = 6, kTicketMinutes = 5;
/// A class needs longer than the estimate for one reader (minutes.h), at most by this factor.
inline constexpr double kClassFactor = 1.5;

struct PlanRow {
  enum class Kind { Opening, Step, Talk, Ticket };
  Kind kind = Kind::Opening;
  std::size_t step = 0;           ///< index of the step, for Kind::Step
  int from_min = 0, minutes = 0;  ///< whole minutes; at least 1 long
};

/// The rows in their order, without gaps. The steps of the core get the rest of the 45 minutes, in proportion to their
/// estimates, but no more than kClassFactor times these. A core that needs more than that rest gets its estimates, so
/// that the sum exceeds kClassMinutes.
std::vector<PlanRow> classPlan(const Lesson& lesson);

/// The minutes of all rows.
int minutesOf(const std::vector<PlanRow>& plan);

}  // namespace moltact
