// Reads the attempts of a class as a teacher collects them: files, and folders with subfolders, for example one per
// student or week. Any thread but the haptic one.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "engine/core/problem.h"
#include "engine/results/class_summary.h"

namespace moltact {

struct ClassReading {
  ClassSummary summary;
  std::vector<Problem> passed_over;  ///< files and lines that could not be read
};

/// Summarizes all attempts in the given files and folders. A file that is found twice counts once. Only one attempt is
/// in memory at a time.
ClassReading readClass(std::span<const std::filesystem::path> files_and_folders, const NamesShown& names = {});

}  // namespace moltact
