// Reads a student's progress from the attempts. Any thread but the haptic one.
//
//   for (const LessonProgress& p : readProgress(attemptsFolder()))     // once, when the welcome page opens: cheap
//     if (p.isOf(file, title)) card.show(p.share(), p.finished, p.step_title, p.began, p.attempts);
//   Expected<Attempt> a = readAttempt(p.file, ReadDepth::NoHipSamples);     // the student resumes the lesson
//   if (a) session.restore(memoryOf(*a));                              // restores the step and the earlier work
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/lesson/session.h"
#include "engine/results/attempt_file.h"

namespace moltact {

struct LessonProgress {
  std::string lesson;  ///< the lesson file's name without folders: "first-touch.md"
  std::string title;
  std::string student;                      ///< of the last attempt; empty if no name was given
  std::filesystem::path file;               ///< the last attempt
  std::string began;                        ///< when the last attempt began: "2026-11-21T10:58:14Z"
  std::filesystem::file_time_type touched;  ///< the last write to its file
  std::string step, step_title;             ///< the student's current step
  std::size_t done = 0, of = 0;             ///< tasks and questions of the last attempt
  bool finished = false;                    ///< any attempt was finished, not necessarily the last
  std::size_t attempts = 0;
  std::vector<std::pair<std::string, std::string>> names;  ///< file and title of all attempts, without duplicates

  /// Whether this is progress in the given lesson, in any language. Files are compared by name without the language;
  /// lessons with the same file name in different folders are distinguished by title.
  bool isOf(const std::filesystem::path& lesson_file, const std::string& its_title) const;
  double share() const { return of ? double(done) / double(of) : 0.0; }
  /// Whether the last attempt is unfinished, so that it can be resumed.
  bool canResume() const { return done < of; }
};

/// Returns one entry per lesson (sameLesson) that was ever begun, the last one touched first. Reads only the beginning
/// and the end of each file, so that hundreds of attempts take no longer than a frame or two. Other files are skipped.
/// `student`: only attempts under this name (no value: all).
std::vector<LessonProgress> readProgress(const std::filesystem::path& folder,
                                         const std::optional<std::string>& student = {});

/// The data from which LessonSession::restore continues an attempt.
SessionMemory memoryOf(const Attempt& attempt);

}  // namespace moltact
