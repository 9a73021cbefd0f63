// One lesson's part of the class page. Any thread but the haptic one.
#pragma once

#include <string>

#include "engine/results/class_summary.h"

namespace moltact {

/// `first`: it does not begin a new sheet of paper.
std::string lessonSection(const LessonSummary& lesson, bool first);

}  // namespace moltact
