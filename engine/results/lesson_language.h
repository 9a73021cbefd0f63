// Combines attempts at the same lesson in different languages. Pure functions; any thread but the haptic one.
#pragma once

#include "engine/results/attempt_file.h"

namespace moltact {

/// Whether two outlines belong to the same lesson: the same file and title, or the file's name in two languages
/// ("first-touch.md", "first-touch.de.md") with the same tasks, questions and choices.
bool sameLesson(const LessonOutline& a, const LessonOutline& b);

/// Replaces the ids of steps and questions by those of `target` if both are the same lesson (sameLesson). An attempt
/// may change its language in between.
Attempt inTermsOf(const LessonOutline& target, Attempt attempt);

}  // namespace moltact
