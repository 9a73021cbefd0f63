// A lesson is one lesson in every language: its attempts in one count in the others. Pure functions; any thread but the
// haptic one.
#pragma once

#include "engine/results/attempt_file.h"

namespace moltact {

/// Whether two outlines are of one lesson: the same file and title, or the file's name in two languages
/// ("first-touch.md", "first-touch.de.md") with the same tasks, questions and choices.
bool sameLesson(const LessonOutline& a, const LessonOutline& b);

/// The same attempt as if it had been made in the target's language: the ids of steps and questions are the target's where
/// both are one lesson (sameLesson). An attempt may change its language on the way.
Attempt inTermsOf(const LessonOutline& target, Attempt attempt);

}  // namespace moltact
