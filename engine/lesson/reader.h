// Reads a lesson, Markdown with front matter (lessons/*.md), into a Lesson, or returns all its errors. Not for the
// haptic thread. Any bytes are safe: the reader neither throws nor hangs, and never reads outside the file.
//
//   front matter between two lines "---"     title, minutes, level, goals, molecules, author, licence
//   ## heading                               a step; its slug is its id, and links lead to it: [look](#a-crease)
//   ## Aside: heading                        an aside, reached only by links: [look](#aside-heading)
//   ```step                                  whether the step must be finished, and which goals it serves
//   ```scene                                 the scene of the step
//   ```touch                                 a touch task; its first key is a task kind (tasks/registry.h)
//   ```facts                                 numbers that `check` computes from the molecule; never shown
//   ### Question: …                          with a task list ("- [x] right → feedback") or an ```answer block
//   > [!TIP]                                 a hint
//   > [!NOTE] Teacher: …                     for the teacher only
//   ## Glossary                              words with their meanings (glossary.h); not a step
//
// keys.h lists the keys of the blocks.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/problem.h"
#include "engine/lesson/lesson.h"

namespace moltact {

struct LessonReading {
  std::optional<Lesson> lesson;   ///< present exactly if there are no errors
  std::optional<Lesson> partial;  ///< the part of a faulty lesson that was understood: for further checks, not for
                                  ///< students
  std::vector<Problem> errors;    ///< every error, in the order of the file
  std::vector<Problem> warnings;  ///< parts that were read but have no effect, in the order of the file
};

/// `name` is the file's name in messages.
LessonReading readLessonText(const std::string& name, std::string bytes);

/// Reads a lesson from a file. A file that cannot be read gives one error.
LessonReading readLesson(const std::filesystem::path& file);

/// The id of a heading, as Git hosts derive it: ASCII letters in lower case, hyphens for spaces. Other ASCII
/// punctuation is removed, except hyphens and underscores.
std::string slug(std::string_view heading);

/// Larger files and longer lines are rejected (unit: byte).
inline constexpr std::size_t kLargestLesson = std::size_t{1} << 20;
inline constexpr std::size_t kLongestLessonLine = 20000;

/// Reading stops at more steps.
inline constexpr std::size_t kMaxLessonSteps = 1000;

}  // namespace moltact
