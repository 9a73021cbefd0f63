// Reads the attempts of a class as a teacher collects them: files, and folders with subfolders, for example one per
// student or week. Any thread but the haptic one.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include "engine/core/problem.h"
#include "engine/results/class_summary.h"

namespace moltact {

struct ClassReading {
  ClassSummary summary;
  std::vector<Problem> passed_over;  ///< files and lines that could not be read
};

/// Passes each attempt in the given files and folders to `take`, in the order in which they began. A file that is found
/// twice is passed once, and only one attempt is in memory at a time. Returns the files and lines that could not be read.
std::vector<Problem> forEachAttempt(std::span<const std::filesystem::path> files_and_folders,
                                    const std::function<void(const Attempt&)>& take);

/// Summarizes all attempts in the given files and folders. A file that is found twice counts once. Only one attempt is
/// in memory at a time.
ClassReading readClass(std::span<const std::filesystem::path> files_and_folders, const NamesShown& names = {});

}  // namespace moltact
