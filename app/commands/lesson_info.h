// The output of `moltact info` for lessons and packs.
#pragma once

#include <string>

namespace moltact {

/// Whether the name has the extension of a lesson (.md) or of a pack (.moltact).
bool namesLesson(const std::string& name);

/// Prints title, author, steps, languages and molecules, and the contents of a pack. Throws CommandError if the file
/// cannot be read.
void printLessonInfo(const std::string& name, bool json);

}  // namespace moltact
