// The attempts of a class, as a teacher collects them: files, and folders with folders in them, one for each student or
// each week. Any thread but the haptic one.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "engine/core/problem.h"
#include "engine/results/attempt_file.h"

namespace moltact {

struct ClassFiles {
  std::vector<Attempt> attempts;
  std::vector<Problem> passed_over;  ///< files and lines that could not be read
};

/// Every attempt in what is named; a file that is met twice counts once.
ClassFiles readClass(std::span<const std::filesystem::path> files_and_folders);

}  // namespace moltact
