// One lesson's part of the class page. Any thread but the haptic one.
#pragma once

#include <string>

#include "engine/results/class_summary.h"

namespace moltact {

/// Appends it. `first`: it does not begin a new sheet of paper.
void lessonSection(std::string& out, const LessonSummary& lesson, bool first);

}  // namespace moltact
