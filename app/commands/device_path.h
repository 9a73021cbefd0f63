// `moltact device path`: prints the path of a recorded hand as rows of numbers.
#pragma once

#include <CLI/CLI.hpp>

#include "engine/core/problem.h"
#include "engine/servo/hand_path.h"

namespace moltact {

/// Adds the command to `moltact device`.
void addDevicePath(CLI::App& device);

/// Reads a hand's path from a recording (.recording) or from a file with rows of numbers.
Expected<HandPath> openHandPath(const std::filesystem::path& file);

}  // namespace moltact
