// A class as one web page that stands alone: its style and charts are in the file, nothing is loaded from elsewhere and
// nothing in it runs. It reads in light and dark, on paper and in black and white. Any thread but the haptic one.
#pragma once

#include <string>
#include <vector>

#include "engine/core/problem.h"
#include "engine/results/class_summary.h"

namespace moltact {

/// The whole file. `passed_over`: files and lines that could not be read, listed at the end; `made`: when, in words.
std::string classPage(const ClassSummary& summary, const std::vector<Problem>& passed_over, const std::string& made);

}  // namespace moltact
