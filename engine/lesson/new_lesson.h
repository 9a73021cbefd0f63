// The small working lesson that an author starts from. Pure functions; any thread but the haptic one.
#pragma once

#include <string>
#include <string_view>

namespace moltact {

/// "haem-pockets" or "Haem pockets" as a title: "Haem pockets". Any text.
std::string lessonTitle(std::string_view name);

/// The name of its file without a folder: "haem-pockets.md". Empty where `name` has no letter or digit.
std::string lessonFileName(std::string_view name);

/// The text of a lesson that passes every check and tells in its comments and notes what each part is for.
std::string newLessonText(std::string_view title);

}  // namespace moltact
