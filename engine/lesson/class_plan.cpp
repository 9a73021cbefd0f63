#include "engine/lesson/class_plan.h"

#include <algorithm>
#include <cmath>

#include "engine/lesson/minutes.h"

namespace moltact {

std::vector<PlanRow> classPlan(const Lesson& lesson) {
  constexpr int kForSteps = kClassMinutes - kOpeningMinutes - kTalkMinutes - kTicketMinutes;
  std::vector<PlanRow> rows{{PlanRow::Kind::Opening, 0, 0, kOpeningMinutes}};
  double all = 0.0;
  for (const Step& step : lesson.steps)
    if (!step.aside) all += minutesOf(step);
  const double factor = all > 0.0 ? std::clamp(kForSteps / all, 1.0, kClassFactor) : 1.0;
  // Each step ends at its rounded share of the sum, so that rounding errors do not add up.
  double exact = 0.0;
  int at = kOpeningMinutes;
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    if (lesson.steps[i].aside) continue;
    exact += factor * minutesOf(lesson.steps[i]);
    const int end = std::max(at + 1, kOpeningMinutes + static_cast<int>(std::lround(exact)));
    rows.push_back({PlanRow::Kind::Step, i, at, end - at});
    at = end;
  }
  rows.push_back({PlanRow::Kind::Talk, 0, at, kTalkMinutes});
  rows.push_back({PlanRow::Kind::Ticket, 0, at + kTalkMinutes, kTicketMinutes});
  return rows;
}

int minutesOf(const std::vector<PlanRow>& plan) {
  return plan.empty() ? 0 : plan.back().from_min + plan.back().minutes;
}

}  // namespace moltact
