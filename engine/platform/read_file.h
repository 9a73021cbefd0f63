// Reads a whole file that a person named. Any thread but the haptic one.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "engine/core/problem.h"

namespace moltact {

/// The bytes of the file. A Problem where it is missing, a folder, no ordinary file (a pipe or a device could give
/// bytes without end, or none for ever), larger than `most_bytes` (`too_large_remedy` says what to do then), or where
/// it cannot be read to its end. Throws std::bad_alloc where the memory does not hold it.
Expected<std::string> readFile(const std::filesystem::path& path, std::size_t most_bytes,
                               const std::string& too_large_remedy);

}  // namespace moltact
