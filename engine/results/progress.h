// How far a student has come, read back from the attempts. Any thread but the haptic one.
//
//   for (const LessonProgress& p : readProgress(attemptsFolder()))     // once, when the welcome page opens: cheap
//     if (p.isOf(file, title)) card.show(p.share(), p.finished, p.step_title, p.began, p.attempts);
//   Expected<Attempt> a = readAttempt(p.file, ReadDepth::NoHipSamples);     // the student wants to go on
//   if (a) session.restore(memoryOf(*a));                              // the step and what was done are as they were
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
  std::string student;                      ///< of the last attempt; empty where no name was given
  std::filesystem::path file;               ///< the last attempt
  std::string began;                        ///< when the last attempt began: "2026-11-21T10:58:14Z"
  std::filesystem::file_time_type touched;  ///< when it was written last
  std::string step, step_title;             ///< where the student was
  std::size_t done = 0, of = 0;             ///< tasks and questions of the last attempt
  bool finished = false;                    ///< some attempt was finished, not necessarily the last
  std::size_t attempts = 0;
  std::vector<std::pair<std::string, std::string>> names;  ///< file and title of all attempts, each once

  /// Whether it is progress in this lesson, in whichever language: the name of its file without the language says it.
  /// Lessons of the same file name in different folders differ in their titles.
  bool isOf(const std::filesystem::path& lesson_file, const std::string& its_title) const;
  double share() const { return of ? double(done) / double(of) : 0.0; }
  /// The last attempt was begun and not finished: it can be taken up again.
  bool canResume() const { return done < of; }
};

/// One entry a lesson (sameLesson) that was ever begun, the last one touched first. Reads the two ends
/// of each file only, so that hundreds of attempts take no longer than a frame or two. A file that is no attempt is
/// skipped. `student`: only attempts under this name (no value: all).
std::vector<LessonProgress> readProgress(const std::filesystem::path& folder,
                                         const std::optional<std::string>& student = {});

/// The data with which a session goes on where an attempt ended; LessonSession::restore takes it.
SessionMemory memoryOf(const Attempt& attempt);

}  // namespace moltact
