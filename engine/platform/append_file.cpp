// What is alike wherever files grow.
#include "engine/platform/append_file.h"

#include <utility>

namespace moltact {

AppendFile::AppendFile(AppendFile&& other) noexcept
    : path_(std::move(other.path_)),
      handle_(std::exchange(other.handle_, -1)),
      empty_(std::exchange(other.empty_, {})),
      unsynced_name_(other.unsynced_name_) {}

AppendFile& AppendFile::operator=(AppendFile&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(handle_, other.handle_);
  std::swap(empty_, other.empty_);
  std::swap(unsynced_name_, other.unsynced_name_);
  return *this;
}

}  // namespace moltact
