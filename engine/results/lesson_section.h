// A lesson's section of the class page. Any thread but the haptic one.
#pragma once

#include <string>

#include "engine/results/class_summary.h"

namespace moltact {

/// Appends the section to `out`. `first`: no page break precedes it in print.
void lessonSection(std::string& out, const LessonSummary& lesson, bool first);

}  // namespace moltact
