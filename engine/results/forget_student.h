// Finds what a folder of results holds about one student, and deletes it. Any thread but the haptic one.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "engine/core/problem.h"

namespace moltact {

/// The files that hold something about a student, each once, in the order of their names.
struct StudentTraces {
  std::string student;
  std::vector<std::filesystem::path> attempts;  ///< the student's own
  struct Predictions {
    std::filesystem::path file;  ///< an attempt of another student
    std::size_t lines = 0;       ///< the student's predictions in it, made while waiting for a turn
  };
  std::vector<Predictions> predictions;
  std::vector<std::filesystem::path> recordings;  ///< of a hand, with the student's name in the name of the file
  std::vector<std::filesystem::path> reports;     ///< pages and tables of `moltact report` that name the student
  std::vector<std::filesystem::path> others;      ///< texts that name the student and are none of these: to be checked
  std::vector<std::string> alike;                 ///< names in other attempts that differ in case or blanks only
  std::size_t nameless = 0;                       ///< attempts without a name, which cannot be searched
  std::vector<Problem> passed_over;               ///< what could not be read

  /// Nothing that forgetStudent() could delete.
  bool empty() const { return attempts.empty() && predictions.empty() && recordings.empty() && reports.empty(); }
};

/// Searches files, and folders with their subfolders down to kDeepestAttempts levels. An attempt is the student's if its
/// name is exactly `student`; recordings, reports and other texts if they contain the name as a word, in either case of
/// letters.
StudentTraces tracesOf(const std::string& student, std::span<const std::filesystem::path> files_and_folders);

/// Deletes the attempts, recordings and reports, and the predictions from the attempts of others. Returns what could not
/// be deleted, for example because a running program writes it; everything else is deleted all the same.
std::vector<Problem> forgetStudent(const StudentTraces& traces);

}  // namespace moltact
