// The results of a class as a self-contained web page: style and charts are in the file, it loads nothing and runs no
// script. It is readable in light and dark, on paper and in black and white. Any thread but the haptic one.
#pragma once

#include <string>
#include <vector>

#include "engine/core/problem.h"
#include "engine/results/class_summary.h"

namespace moltact {

/// Returns the whole file. `passed_over`: files and lines that could not be read, listed at the end; `made`: the date
/// in words.
std::string classPage(const ClassSummary& summary, const std::vector<Problem>& passed_over, const std::string& made);

}  // namespace moltact
