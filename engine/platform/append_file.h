// A file that only grows, each time by a whole piece or not at all, and that only one program writes at a time. Any one
// thread but the haptic one (it waits for the disk).
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
    New,       ///< the file must not exist yet; it is removed if nothing was ever appended
    Continue,  ///< the file exists; appended bytes come after its content
    Replace,   ///< the existing file stays until the first piece has been appended, which replaces it (write_file.h)
  };

  /// Opens for appending and locks the file against other programs of this kind. A Problem that a person can act on
  /// where that is impossible, or another program has the file open, or it would replace what the command that runs has
  /// read or written (file_guard.h).
  static Expected<AppendFile> open(const std::filesystem::path& path, Begin begin);

  AppendFile(AppendFile&& other) noexcept;
  AppendFile& operator=(AppendFile&& other) noexcept;
  ~AppendFile();

  /// Hands the bytes to the system: from then on they survive a crash of this program. On a Problem (a full disk) the
  /// file is as it was before.
  std::optional<Problem> append(std::string_view bytes);

  /// Waits until the disk has all of it: from then on it survives a crash of the computer. For a new file its name is
  /// included.
  std::optional<Problem> sync();

  /// Truncates the file to that many bytes.
  std::optional<Problem> cut(std::uintmax_t bytes);

 private:
  AppendFile(std::filesystem::path path, int handle) : path_(std::move(path)), handle_(handle) {}
  static Expected<AppendFile> openInSystem(const std::filesystem::path& path, Begin begin);

  std::filesystem::path path_;
  int handle_ = -1;
  std::filesystem::path empty_;  // the new file or draft while nothing is in it; none where the file existed before
  bool unsynced_name_ = false;   // its folder's entry has not been synchronised yet
};

}  // namespace moltact
