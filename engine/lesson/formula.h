// A simple formula, written between dollar signs as in LaTeX ("$F = k \cdot d^2$"), as text with scripts: letters are
// slanted, fractions stand on the line. Pure function; any thread but the haptic one.
#pragma once

#include <string_view>
#include <vector>

#include "engine/core/problem.h"
#include "engine/lesson/lesson.h"

namespace moltact {

/// The formula's text. What it has that is not known is shown as written and adds a problem, without a file's name;
/// `place` is that of its first character, and it stands on one line.
RichText formulaText(std::string_view formula, Place place, std::vector<Problem>& problems);

}  // namespace moltact
