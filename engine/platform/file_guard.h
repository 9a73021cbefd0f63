// Keeps a command's outputs apart from what it reads and from each other, so that no mistake at the command line costs
// a file. Files are compared as the system identifies them (device and inode), through links; a file that does not
// exist yet is compared by its canonical path. Every way to write a file (write_file.h, append_file.h) asks here. Any
// thread but the haptic one.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/problem.h"

namespace moltact {

/// From here to its end this process refuses to write a file that it has read, or to write one twice. One at a time.
/// Without one everything is allowed: the window reads its settings and writes them again.
class FileGuard {
 public:
  FileGuard();
  ~FileGuard();
  FileGuard(const FileGuard&) = delete;
  FileGuard& operator=(const FileGuard&) = delete;
};

/// Whether both names lead to the same file, which need not exist.
bool sameFile(const std::filesystem::path& a, const std::filesystem::path& b);

/// Notes an input; `openFile` (read_file.h) does so with whatever it opens. Nothing without a guard.
void noteRead(const std::filesystem::path& file);
/// Notes an output that is in its place; `Draft` and `AppendFile` do so.
void noteWritten(const std::filesystem::path& file);

/// Why this file must not be written: it is an input, or an output already. Anything but an ordinary file may be both.
std::optional<Problem> whyNotWritten(const std::filesystem::path& file);

/// An output that a command will write, and how it was named: "--csv".
struct NamedOutput {
  std::string option;
  std::filesystem::path file;  ///< empty: not asked for
};
/// The same for all outputs of a command before the first is written.
std::optional<Problem> whyNotWritten(const std::vector<NamedOutput>& outputs);

}  // namespace moltact
