// What `moltact info` says of a lesson and of a pack.
#pragma once

#include <string>

namespace moltact {

/// Whether the name is that of a lesson (.md) or of a pack (.moltact).
bool namesLesson(const std::string& name);

/// Prints title, author, steps, languages and molecules, and what a pack holds. Throws CommandError where it cannot be
/// read.
void printLessonInfo(const std::string& name, bool json);

}  // namespace moltact
