// Reads a lesson: Markdown with front matter (lessons/*.md) into a Lesson, or every problem in it at once.
// Not for the haptic thread. Any bytes are safe: nothing throws, hangs or points outside the file.
//
//   front matter between two lines "---"     title, minutes, level, goals, molecules, author, licence
//   ## heading                               a step; its slug is its id, and links lead to it: [look](#a-crease)
//   ## Aside: heading                        a side path, which only links lead to: [look](#aside-heading)
//   ```step                                  whether the step must be finished, and which goals it serves
//   ```scene                                 what is on the stage
//   ```touch                                 something to do by touch; its first key is a task kind (tasks/registry.h)
//   ### Question: …                          with a task list ("- [x] right → feedback") or an ```answer block
//   > [!TIP]                                 a hint
//   > [!NOTE] Teacher: …                     for the teacher only
//   ## Glossary                              words with their meanings (glossary.h), which is no step
//
// The keys of the blocks are in keys.h.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/problem.h"
#include "engine/lesson/lesson.h"

namespace moltact {

struct LessonReading {
  std::optional<Lesson> lesson;   ///< present exactly when there are no errors
  std::optional<Lesson> partial;  ///< what was understood of a lesson with errors: for more checks, not for students
  std::vector<Problem> errors;    ///< every error, in the order of the file
  std::vector<Problem> warnings;  ///< what was read but will not be used, in the order of the file
};

/// `name` is the file's name as messages give it.
LessonReading readLessonText(const std::string& name, std::string bytes);

/// The same from a file. A file that cannot be read gives one error.
LessonReading readLesson(const std::filesystem::path& file);

/// The id that a heading gets, as Git hosts make it: small letters, hyphens for spaces, no other signs.
std::string slug(std::string_view heading);

/// Larger files and longer lines are refused (unit: byte).
inline constexpr std::size_t kLargestLesson = std::size_t{1} << 20;
inline constexpr std::size_t kLongestLessonLine = 20000;

/// A lesson with more steps is not read on.
inline constexpr std::size_t kMaxLessonSteps = 1000;

}  // namespace moltact
