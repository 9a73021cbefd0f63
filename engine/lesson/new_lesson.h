// Generates a small working lesson as a starting point for authors. Pure functions; any thread but the haptic one.
#pragma once

#include <string>
#include <string_view>

namespace moltact {

/// Converts "haem-pockets" or "Haem pockets" to a title: "Haem pockets". Accepts any text.
std::string lessonTitle(std::string_view name);

/// The file name without a folder: "haem-pockets.md". Empty if `name` has no letter or digit.
std::string lessonFileName(std::string_view name);

/// The text of a lesson that passes every check. Its comments and notes explain each part.
std::string newLessonText(std::string_view title);

}  // namespace moltact
