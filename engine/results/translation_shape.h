// Compares a lesson with a translation of it. A learning platform counts all languages of a lesson as one, so their
// steps, tasks and questions must correspond. Pure functions; any thread but the haptic one.
#pragma once

#include <optional>
#include <string>

#include "engine/core/problem.h"
#include "engine/lesson/lesson.h"

namespace moltact {

/// The first difference in the order and kind of steps, tasks, questions and choices, at its place in the translation;
/// no value if there is none. Texts and ids may differ. `lesson_file`, `translation_file`: names for the message.
std::optional<Problem> translationFault(const Lesson& lesson, const std::string& lesson_file, const Lesson& translation,
                                        const std::string& translation_file);

}  // namespace moltact
