// The authors' reference of every key, fence, task, unit and word of selections, as a Markdown page. It is made from
// the tables with which lessons are read, so it cannot say anything else than they do. Pure function.
#pragma once

#include <string>

namespace moltact {

/// docs/lesson-reference.md.
std::string lessonReference();

}  // namespace moltact
