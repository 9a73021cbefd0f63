// The state of an attempt as a short text, which a learning platform keeps until the lesson is continued, perhaps on
// another computer (cmi.suspend_data of SCORM). JSON in ASCII. It contains the student's answers and which of them were
// right, but no right answer that was not given. Pure functions; any thread but the haptic one.
//
//   ["moltact", 1, began, sittings, seconds, step, done, of, [steps], [skipped steps]]
//   step: [key, tasks as characters: s solved, x shown, - open, [questions]]
//   question: [key, tries, flags: 1 first right, 2 ever right, 4 last right, first answer, last answer if another]
//
// A key is the place in the lesson and a hash of the id, so that a corrected lesson still finds its steps. An answer is
// a list of choices or a text.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "engine/core/problem.h"
#include "engine/results/attempt_file.h"

namespace moltact {

/// Limits of the standards (unit: character).
inline constexpr std::size_t kSuspendScorm12 = 4096, kSuspendScorm2004 = 64000;

/// The text in at most `max_chars`. What the place needs goes first: if the whole does not fit, typed answers are left
/// out, then the choices taken, then the questions, then the tasks of the steps that were entered first. Empty if even
/// the place does not fit, which takes at most 200 characters.
std::string suspendedText(const Attempt& attempt, std::size_t max_chars);

/// The attempt as far as the text contains it, for the lesson with this outline: every event has the text's time. What
/// the lesson no longer contains is left out. A Problem if the text is damaged or of a newer format.
Expected<Attempt> fromSuspended(std::string_view text, const LessonOutline& lesson);

/// Longer texts are rejected (unit: byte).
inline constexpr std::size_t kLongestSuspended = std::size_t{256} << 10;

}  // namespace moltact
