// Reads a file named by the user, as a whole or in pieces. Any thread except the haptic one; the calls block on the
// disk.
#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>

#include "engine/core/problem.h"

namespace moltact {

/// A file opened for reading from its start.
struct OpenFile {
  std::ifstream in;
  std::size_t size = 0;  ///< at the time of opening (unit: byte)
};

/// Opens an input file of the running command (file_guard.h). Returns a Problem if it is missing, a folder, not an
/// ordinary file, larger than `max_bytes` or not readable. A pipe or a device is refused because it could give bytes
/// without end or none. `too_large_remedy` is the remedy for a file that is too large.
Expected<OpenFile> openFile(const std::filesystem::path& file, std::size_t max_bytes,
                            const std::string& too_large_remedy);

/// Returns the bytes of the file, or a Problem as openFile() or if reading fails. Throws std::bad_alloc if memory is
/// insufficient.
Expected<std::string> readFile(const std::filesystem::path& path, std::size_t max_bytes,
                               const std::string& too_large_remedy);

/// The Problem "reading it broke off after 700 bytes".
Problem brokenOff(const std::string& file, std::size_t bytes);

}  // namespace moltact
