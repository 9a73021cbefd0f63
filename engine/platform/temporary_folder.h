// A private temporary folder, inaccessible to other users. Any thread except the haptic one.
#pragma once

#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

#include "engine/core/problem.h"

namespace moltact {

class TemporaryFolder {
 public:
  /// Creates a folder inside an existing one, under a name that starts with `prefix`. Returns a Problem if that fails.
  static Expected<TemporaryFolder> in(const std::filesystem::path& folder, std::string_view prefix);

  TemporaryFolder(TemporaryFolder&& other) noexcept
      : path_(std::exchange(other.path_, {})), lock_(std::exchange(other.lock_, -1)) {}
  TemporaryFolder& operator=(TemporaryFolder&& other) noexcept {
    std::swap(path_, other.path_);
    std::swap(lock_, other.lock_);
    return *this;
  }
  /// Removes the folder and its contents.
  ~TemporaryFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  explicit TemporaryFolder(std::filesystem::path path, int lock = -1) : path_(std::move(path)), lock_(lock) {}
  std::filesystem::path path_;  // empty: moved from
  int lock_ = -1;               // Linux: a handle that the system unlocks when the program ends for any reason
};

/// Removes folders in `folder` whose names start with `prefix` and whose program ended without removing them. On Linux
/// these are the unlocked ones, elsewhere those older than a day.
void sweepTemporaryFolders(const std::filesystem::path& folder, std::string_view prefix);

/// Moves the folder `fresh` to `place`. The previous folder is moved to `old`; on an error it is restored and the error
/// returned. All three must be on one file system.
std::error_code replaceFolder(const std::filesystem::path& fresh, const std::filesystem::path& place,
                              const std::filesystem::path& old);

}  // namespace moltact
