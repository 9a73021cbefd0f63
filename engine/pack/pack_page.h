// A pack inside a browser edition: one page (.html) that starts with the pack's lesson and contains the program,
// without network access (docs/browser.md). Any thread except the haptic one.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/core/problem.h"

namespace moltact {

inline constexpr std::size_t kMaxPageBytes = std::size_t{64}
                                             << 20;  ///< limit on the page without the lesson (unit: byte)

/// A script element that holds data. `text` must contain no "</", as base64 and JSON of plain names do not.
struct PageElement {
  std::string id, type, text;
  std::vector<std::pair<std::string, std::string>> attributes = {};
};
/// The element for a pack; `name` is the lesson's name without ending.
PageElement packElement(const std::string& id, const std::string& name, std::string_view pack);

/// Inserts elements into the browser edition `page` (the text of moltact.html, read from `page_file`). Returns a Problem
/// if the page is not a browser edition or already contains a lesson.
Expected<std::string> pageWithElements(std::string page, const std::string& page_file,
                                       const std::vector<PageElement>& elements);

/// Inserts the pack into the browser edition `page` (the text of moltact.html, read from `page_file`). `name` is the
/// lesson's name without ending. `attributes` are added to the element that holds the pack. Returns a Problem if the page is not a browser edition or already contains a lesson.
Expected<std::string> pageWithPack(std::string page, const std::string& page_file, const std::string& name,
                                   std::string_view pack,
                                   const std::vector<std::pair<std::string, std::string>>& attributes = {});

}  // namespace moltact
