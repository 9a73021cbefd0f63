// The attempts of a class, as a teacher collects them: files, and folders with folders in them, one for each student or
// each week. Any thread but the haptic one.
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

/// Counts every attempt in what is named; a file that is met twice counts once. Only one attempt is in memory at a time.
ClassReading readClass(std::span<const std::filesystem::path> files_and_folders, const NamesShown& names = {});

}  // namespace moltact
