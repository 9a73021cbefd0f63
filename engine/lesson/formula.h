// Converts a simple LaTeX formula between dollar signs ("$F = k \cdot d^2$") to text with sub- and superscripts.
// Letters are in italics, fractions on one line. Pure function; any thread but the haptic one.
#pragma once

#include <string_view>
#include <vector>

#include "engine/core/problem.h"
#include "engine/lesson/lesson.h"

namespace moltact {

/// Returns the formula's text. Unknown parts are shown as written and add a problem without a file's name. `place` is
/// the place of its first character; the formula is on one line.
RichText formulaText(std::string_view formula, Place place, std::vector<Problem>& problems);

}  // namespace moltact
