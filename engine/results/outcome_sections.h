// The outcomes of a class in a lesson, as sections of the report's page: by goal, by misconception, and by the order of
// steps. Each is empty if there is nothing to report. Pure functions; any thread but the haptic one.
#pragma once

#include <string>

#include "engine/results/class_summary.h"

namespace moltact {

/// The results for each goal to which the author has assigned tasks or questions.
std::string goalSection(const LessonSummary& lesson);

/// The misconceptions with which the author tagged wrong choices.
std::string misconceptionSection(const LessonSummary& lesson);

/// How well each student distinguished two things in the dark before and after the explanation, and the gain of the
/// class. Only for a lesson that asks a task twice.
std::string gainSection(const LessonSummary& lesson);

/// The order of steps of each student, if anyone left the regular order.
std::string waySection(const LessonSummary& lesson);

}  // namespace moltact
