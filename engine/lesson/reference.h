// Generates the authors' reference of all keys, fences, tasks, units and selection words as a Markdown page. It uses
// the same tables as the lesson reader, so that both always agree. Pure function.
#pragma once

#include <string>

namespace moltact {

/// docs/lesson-reference.md.
std::string lessonReference();

}  // namespace moltact
