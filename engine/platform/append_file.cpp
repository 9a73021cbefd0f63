// The part of append_file.h common to all systems.
#include "engine/platform/append_file.h"

#include <utility>

#include "engine/platform/file_guard.h"

namespace moltact {

Expected<AppendFile> AppendFile::open(const std::filesystem::path& path, Begin begin) {
  if (begin == Begin::Replace)
    if (auto problem = overwriteProblem(path)) return *std::move(problem);
  Expected<AppendFile> file = openInSystem(path, begin);
  if (file && begin != Begin::Continue) noteWritten(path);
  return file;
}

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
