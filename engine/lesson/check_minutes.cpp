// Compares the author's minutes with the estimate from text and tasks.
#include <algorithm>
#include <cmath>

#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"
#include "engine/lesson/checks.h"
#include "engine/lesson/minutes.h"

namespace moltact::checks {

void minutes(const Lesson& lesson, Findings& findings) {
  const LessonMinutes worked_out = minutesOf(lesson);
  const std::string core = numberText(std::max(1.0, worked_out.core), decimals(0));
  // A card shows whole minutes, so short lessons may differ by half a minute.
  const double off = std::abs(lesson.minutes - std::max(1.0, worked_out.core));
  if (lesson.minutes > 0 && off > std::max(0.5, kMinutesOff * worked_out.core))
    findings.warning(lesson.minutes_place,
                     trf("the lesson says {0} minutes, but its core takes about {1}", lesson.minutes, core),
                     trf("write {0}, or take the line out: the minutes are then worked out", core));
  if (worked_out.core > kMaxCoreMinutes)
    findings.warning(lesson.minutes_place.line ? lesson.minutes_place : Place{1, 1},
                     trf("the core of the lesson takes about {0} minutes, more than {1}", core,
                         numberText(kMaxCoreMinutes, decimals(0))),
                     tr("shorten it, or mark steps as extra with 'extra: yes' in a step block"));
}

}  // namespace moltact::checks
