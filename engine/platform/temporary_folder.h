// A folder of one's own for a while, which nobody else may look into. Any thread but the haptic one.
#pragma once

#include <filesystem>
#include <string_view>
#include <system_error>
#include <utility>

#include "engine/core/problem.h"

namespace moltact {

class TemporaryFolder {
 public:
  /// In a folder that must be there, under a name that begins with `prefix`. A Problem where it cannot be made.
  static Expected<TemporaryFolder> in(const std::filesystem::path& folder, std::string_view prefix);

  TemporaryFolder(TemporaryFolder&& other) noexcept
      : path_(std::exchange(other.path_, {})), lock_(std::exchange(other.lock_, -1)) {}
  TemporaryFolder& operator=(TemporaryFolder&& other) noexcept {
    std::swap(path_, other.path_);
    std::swap(lock_, other.lock_);
    return *this;
  }
  /// It goes with all that is in it.
  ~TemporaryFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  explicit TemporaryFolder(std::filesystem::path path, int lock = -1) : path_(std::move(path)), lock_(lock) {}
  std::filesystem::path path_;  // empty: moved from
  int lock_ = -1;               // on Linux a handle that the system unlocks when the program ends, however it ends
};

/// Removes the folders in `folder` under names that begin with `prefix` whose program has ended without removing them:
/// on Linux those that no program has locked, elsewhere those of yesterday and before.
void sweepTemporaryFolders(const std::filesystem::path& folder, std::string_view prefix);

/// Puts the folder `fresh` at `place`. What was there goes to `old`; it comes back, with the error, where `fresh` cannot
/// go there. All three are on one disk.
std::error_code replaceFolder(const std::filesystem::path& fresh, const std::filesystem::path& place,
                              const std::filesystem::path& old);

}  // namespace moltact
