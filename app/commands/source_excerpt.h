// A line of a text file with a mark under one of its columns, as compilers show errors. Pure function.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace moltact {

/// Two lines: the source line, and a caret under its `column` (a code point, from 1; one beyond the end is the place
/// just after it). Lines wider than a terminal are cut to the part round the caret. Tabs stay tabs, and letters that
/// take two places or none in a terminal are counted as such, so that the caret stands right.
std::string sourceExcerpt(std::string_view line, std::size_t column);

}  // namespace moltact
