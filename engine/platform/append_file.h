// A file that only grows, each time by a whole piece or not at all, and that one program writes at a time. The
// operating system's edge; any one thread but the haptic one (it waits for the disk).
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
    New,       ///< the file must not be there yet; it goes again where nothing was ever appended
    Continue,  ///< the file is there; what is appended comes after it
    Replace,   ///< what is there stays until the first piece has been appended, which takes its place (write_file.h)
  };

  /// Opens for appending and keeps other programs of this kind from doing so. A Problem that a person can act on where
  /// that cannot be, or another program has the file open.
  static Expected<AppendFile> open(const std::filesystem::path& path, Begin begin);

  AppendFile(AppendFile&& other) noexcept;
  AppendFile& operator=(AppendFile&& other) noexcept;
  ~AppendFile();

  /// Hands the bytes to the system: from then on they outlive this program. On a Problem (a full disk) the file is as
  /// it was before.
  std::optional<Problem> append(std::string_view bytes);

  /// Waits until the disk has all of it: from then on it outlives the computer. With a file just made, its name as
  /// well.
  std::optional<Problem> sync();

  /// Cuts the file to so many bytes.
  std::optional<Problem> cut(std::uintmax_t bytes);

 private:
  AppendFile(std::filesystem::path path, int handle) : path_(std::move(path)), handle_(handle) {}

  std::filesystem::path path_;
  int handle_ = -1;
  std::filesystem::path
      empty_;                   // the file while nothing is in it: as named, or a draft; none where it was there before
  bool unsynced_name_ = false;  // its folder's entry has not been synchronised yet
};

}  // namespace moltact
