// A file to which data are only appended, each piece completely or not at all, by one program at a time. Any one thread
// except the haptic one; every call may block on the disk.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>

#include "engine/core/problem.h"

namespace moltact {

class AppendFile {
 public:
  enum class Begin {
    New,       ///< the file must not exist; it is removed if nothing was appended
    Continue,  ///< the file exists; bytes are appended to its content
    Replace,   ///< the existing file stays until the first piece has been appended, which replaces it (write_file.h)
  };

  /// Opens a file for appending and locks it against other instances. Returns a Problem with a remedy on failure, if
  /// another program has locked the file, or if it is an input or output of the running command (file_guard.h).
  static Expected<AppendFile> open(const std::filesystem::path& path, Begin begin);

  AppendFile(AppendFile&& other) noexcept;
  AppendFile& operator=(AppendFile&& other) noexcept;
  ~AppendFile();

  /// Passes the bytes to the system; they then survive a crash of this program. After a Problem (for example a full
  /// disk) the file is unchanged.
  std::optional<Problem> append(std::string_view bytes);

  /// Blocks until the bytes are on the disk; they then survive a crash of the computer. For a new file this includes
  /// the directory entry.
  std::optional<Problem> sync();

  /// Truncates the file to that many bytes.
  std::optional<Problem> cut(std::uintmax_t bytes);

 private:
  AppendFile(std::filesystem::path path, int handle) : path_(std::move(path)), handle_(handle) {}
  static Expected<AppendFile> openInSystem(const std::filesystem::path& path, Begin begin);

  std::filesystem::path path_;
  int handle_ = -1;
  std::filesystem::path empty_;  // the new file or draft while it is empty; otherwise none
  bool unsynced_name_ = false;   // the directory entry has not been synchronised yet
};

}  // namespace moltact
