// Protects a command's input files from being overwritten, and its outputs from each other. Files are compared by
// device and inode, through links; a file that does not exist yet is compared by its canonical path. All functions that
// write files (write_file.h, append_file.h) use it. Any thread except the haptic one.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/problem.h"

namespace moltact {

/// While it exists, this process refuses to write a file that it has read, and to write a file twice. One instance at a
/// time. Without a guard everything is allowed: the window reads its settings and writes them again.
class FileGuard {
 public:
  FileGuard();
  ~FileGuard();
  FileGuard(const FileGuard&) = delete;
  FileGuard& operator=(const FileGuard&) = delete;
};

/// True if both names denote the same file, which need not exist.
bool sameFile(const std::filesystem::path& a, const std::filesystem::path& b);

/// Registers an input. `openFile` (read_file.h) calls it for every file. Without a guard it does nothing.
void noteRead(const std::filesystem::path& file);
/// Registers a completed output. Called by `Draft` and `AppendFile`.
void noteWritten(const std::filesystem::path& file);

/// The reason why this file must not be written: it is an input or already an output. Only ordinary files are checked.
std::optional<Problem> overwriteProblem(const std::filesystem::path& file);

/// An output that a command will write, with the option that names it: "--csv".
struct NamedOutput {
  std::string option;
  std::filesystem::path file;  ///< empty: not requested
};
/// The same check for all outputs of a command, before the first is written.
std::optional<Problem> overwriteProblem(const std::vector<NamedOutput>& outputs);

}  // namespace moltact
