// `moltact device path`: the way of a recorded hand as rows of numbers.
#pragma once

#include <CLI/CLI.hpp>

#include "engine/bench/hand_path.h"
#include "engine/core/problem.h"

namespace moltact {

/// Adds it to `moltact device`.
void addDevicePath(CLI::App& device);

/// A hand's way from a file: a recording (.recording), or rows of numbers.
Expected<bench::HandPath> openHandPath(const std::filesystem::path& file);

}  // namespace moltact
