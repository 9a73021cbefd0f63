// Shows a line of a text file with a caret under one of its columns, as compilers show errors. Pure function.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace moltact {

/// Returns two lines: the source line, and a caret under `column`, which counts code points from 1. For a column beyond
/// the end, the caret stands just after the line. Lines wider than a terminal are cut to the part around the caret.
/// Tabs are kept. Characters of double or zero width are counted as such, so that the caret is aligned.
std::string sourceExcerpt(std::string_view line, std::size_t column);

}  // namespace moltact
