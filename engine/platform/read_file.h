// Reads a file that a person named, whole or piece by piece. Any thread but the haptic one.
#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>

#include "engine/core/problem.h"

namespace moltact {

/// A file that is read from its beginning on.
struct OpenFile {
  std::ifstream in;
  std::size_t size = 0;  ///< when it was opened (unit: byte)
};

/// Opens the file, an input of the command that runs (file_guard.h). A Problem where it is missing, a folder, no ordinary file (a pipe or a device could give bytes
/// without end, or none for ever), larger than `most_bytes` (`too_large_remedy` says what to do then), or may not be
/// read.
Expected<OpenFile> openFile(const std::filesystem::path& file, std::size_t most_bytes,
                            const std::string& too_large_remedy);

/// The bytes of the file; a Problem as openFile, or where it cannot be read to its end. Throws std::bad_alloc where the
/// memory does not hold it.
Expected<std::string> readFile(const std::filesystem::path& path, std::size_t most_bytes,
                               const std::string& too_large_remedy);

/// "reading it broke off after 700 bytes".
Problem brokenOff(const std::string& file, std::size_t bytes);

}  // namespace moltact
