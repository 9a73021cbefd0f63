// What a class has come to in a lesson, as parts of the report's page: by goal, by misconception, and by which way. Each is
// empty where there is nothing to tell. Pure functions; any thread but the haptic one.
#pragma once

#include <string>

#include "engine/results/class_summary.h"

namespace moltact {

/// What was done for each goal, where the author has said what serves it.
std::string goalSection(const LessonSummary& lesson);

/// What wrong choices have in common, as the author tagged them.
std::string misconceptionSection(const LessonSummary& lesson);

/// How well each student told two things apart in the dark before and after the explanation, and the gain of the class;
/// only of a lesson that asks a task twice.
std::string gainSection(const LessonSummary& lesson);

/// Where each student went; only where somebody left the straight way.
std::string waySection(const LessonSummary& lesson);

}  // namespace moltact
