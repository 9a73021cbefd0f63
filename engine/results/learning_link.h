// Connects the attempts on this computer with a learning platform: finds or restores the attempt to go on with, and
// reads what was added to its file since the last look. Window's thread.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "engine/core/problem.h"
#include "engine/results/attempt_file.h"

namespace moltact {

/// The file of the attempt that a platform suspended with this text. If `folder` contains the same attempt, at least as
/// far, it is that one; otherwise an attempt is written from the text. A Problem if the text is damaged or nothing can
/// be written.
Expected<std::filesystem::path> attemptToResume(const std::filesystem::path& folder, std::string_view suspended,
                                                const LessonOutline& lesson);

/// The attempt in a file that grows. Reads only what is new, and skips the path of the hand.
class GrowingAttempt {
 public:
  /// `lesson`: the lesson of the platform, in the language of its manifest; ids of a translation are replaced by its
  /// own.
  explicit GrowingAttempt(LessonOutline lesson) : lesson_(std::move(lesson)) {}

  /// Reads on, or anew if it is another file. Files of another lesson are ignored, and the attempt read before stays.
  /// Returns whether there are new lines.
  bool read(const std::filesystem::path& file);
  /// Null before there is one.
  const Attempt* attempt() const { return attempt_ ? &*attempt_ : nullptr; }

 private:
  LessonOutline lesson_;
  std::filesystem::path file_;
  std::size_t read_bytes_ = 0;
  std::optional<Attempt> raw_, attempt_;  // as in the file; in terms of lesson_
};

}  // namespace moltact
