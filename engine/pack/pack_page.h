// A pack in a browser edition of its own: one page (.html) that opens at the pack's lesson, with the program inside and no
// need of a network (docs/browser.md). Any thread but the haptic one.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "engine/core/problem.h"

namespace moltact {

inline constexpr std::size_t kLargestPage = std::size_t{64} << 20;  ///< of the page without the lesson (unit: byte)

/// Puts the pack into the browser edition `page` (the text of moltact.html, read from `page_file`). `name` is the
/// lesson's, without an ending. A Problem where the page is no browser edition, or has a lesson already.
Expected<std::string> pageWithPack(std::string page, const std::string& page_file, const std::string& name,
                                   std::string_view pack);

}  // namespace moltact
