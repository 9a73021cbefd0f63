#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <utility>

#include "engine/platform/append_file.h"
#include "engine/platform/draft_calls_linux.h"

namespace moltact {

using namespace platform;

Expected<AppendFile> AppendFile::openInSystem(const std::filesystem::path& path, Begin begin) {
  constexpr int kFlags = O_WRONLY | O_APPEND | O_CLOEXEC;
  struct stat there {};
  // A file that is not ordinary (a pipe, a device) is written directly.
  if (begin == Begin::Replace && ::stat(path.c_str(), &there) == 0 && !S_ISREG(there.st_mode)) begin = Begin::Continue;
  AppendFile file(path, -1);
  // Locks are skipped on file systems that do not support them (some network ones).
  const auto lockedByAnother = [](int handle) {
    return uninterrupted([&] { return ::flock(handle, LOCK_EX | LOCK_NB); }) != 0 && errno == EWOULDBLOCK;
  };
  if (begin == Begin::Replace) {
    file.path_ = behindLinks(path);
    if (const int old = ::open(file.path_.c_str(), O_RDONLY | O_CLOEXEC); old >= 0) {
      const bool busy = lockedByAnother(old);
      ::close(old);
      if (busy) return writingProblem(path, EWOULDBLOCK);
    }
    file.handle_ = openDraft(file.path_, kFlags, file.empty_);
    if (file.handle_ >= 0) return file;
    file.empty_.clear();
    return writingProblem(path, errno);
  }
  const bool make = begin == Begin::New;
  file.handle_ = uninterrupted([&] { return ::open(path.c_str(), kFlags | (make ? O_CREAT | O_EXCL : 0), 0666); });
  if (file.handle_ < 0) return writingProblem(path, errno);
  if (make) file.empty_ = path;
  file.unsynced_name_ = make;
  if (lockedByAnother(file.handle_)) {
    file.empty_.clear();
    return writingProblem(path, EWOULDBLOCK);
  }
  return file;
}

AppendFile::~AppendFile() {
  if (!empty_.empty()) ::unlink(empty_.c_str());
  if (handle_ >= 0) ::close(handle_);
}

std::optional<Problem> AppendFile::append(std::string_view bytes) {
  struct stat before {};
  if (::fstat(handle_, &before) != 0) return writingProblem(path_, errno);
  const bool some = !bytes.empty();
  while (!bytes.empty()) {
    const ssize_t written = uninterrupted([&] { return ::write(handle_, bytes.data(), bytes.size()); });
    if (written <= 0) {
      const int error = written < 0 ? errno : ENOSPC;
      // A partly written piece is removed; a file that cannot be truncated has none.
      if (::ftruncate(handle_, before.st_size) != 0) errno = error;
      return writingProblem(path_, error);
    }
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  if (!some || empty_.empty()) return std::nullopt;
  if (empty_ != path_) {
    // The replaced file is complete; it must not be replaced by a name without its bytes.
    if (syncData(handle_) != 0 || placeDraft(empty_, path_, false) != 0) {
      const int error = errno;
      if (::ftruncate(handle_, before.st_size) != 0) errno = error;
      return writingProblem(path_, error);
    }
    unsynced_name_ = true;
  }
  empty_.clear();
  return std::nullopt;
}

std::optional<Problem> AppendFile::sync() {
  if (syncData(handle_) != 0) return writingProblem(path_, errno);
  if (std::exchange(unsynced_name_, false)) syncName(path_);
  return std::nullopt;
}

std::optional<Problem> AppendFile::cut(std::uintmax_t bytes) {
  if (uninterrupted([&] { return ::ftruncate(handle_, static_cast<off_t>(bytes)); }) != 0)
    return writingProblem(path_, errno);
  return std::nullopt;
}

}  // namespace moltact
