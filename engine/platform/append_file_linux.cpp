#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "engine/platform/append_file.h"

namespace moltact {
namespace {

Problem problemOf(const std::filesystem::path& path, int error) {
  Problem p{path.string(), 0, 0, {}, {}};
  switch (error) {
    case ENOSPC:
    case EDQUOT:
      p.message = "the disk is full";
      p.remedy = "free some space on it";
      break;
    case EROFS:
    case EACCES:
    case EPERM:
      p.message = "it may not be written";
      p.remedy = "allow writing to its folder";
      break;
    case ENOENT:
    case ENOTDIR:
      p.message = "its folder is not there";
      p.remedy = "make the folder";
      break;
    case EEXIST:
      p.message = "it is already there";
      break;
    case EWOULDBLOCK:
      p.message = "another Moltact is writing it";
      p.remedy = "close the other window";
      break;
    default:
      p.message = std::string("it cannot be written (") + std::strerror(error) + ")";
      p.remedy = "check the disk";
  }
  return p;
}

template <class Call>
auto uninterrupted(Call call) {
  auto result = call();
  while (result == -1 && errno == EINTR) result = call();
  return result;
}

}  // namespace

Expected<AppendFile> AppendFile::open(const std::filesystem::path& path, Begin begin) {
  const bool make = begin == Begin::New;
  const int flags = O_WRONLY | O_APPEND | O_CLOEXEC | (make ? O_CREAT | O_EXCL : 0);
  const int handle = uninterrupted([&] { return ::open(path.c_str(), flags, 0644); });
  if (handle < 0) return problemOf(path, errno);
  AppendFile file(path, handle, make);
  // Folders that know no locks (some network ones) do without.
  if (uninterrupted([&] { return ::flock(handle, LOCK_EX | LOCK_NB); }) != 0 && errno == EWOULDBLOCK) return problemOf(path, EWOULDBLOCK);
  return file;
}

AppendFile::AppendFile(AppendFile&& other) noexcept
    : path_(std::move(other.path_)), handle_(std::exchange(other.handle_, -1)), made_(other.made_) {}

AppendFile& AppendFile::operator=(AppendFile&& other) noexcept {
  std::swap(path_, other.path_);
  std::swap(handle_, other.handle_);
  std::swap(made_, other.made_);
  return *this;
}

AppendFile::~AppendFile() {
  if (handle_ >= 0) ::close(handle_);
}

std::optional<Problem> AppendFile::append(std::string_view bytes) {
  struct stat before {};
  if (::fstat(handle_, &before) != 0) return problemOf(path_, errno);
  while (!bytes.empty()) {
    const ssize_t written = uninterrupted([&] { return ::write(handle_, bytes.data(), bytes.size()); });
    if (written <= 0) {
      const int error = written < 0 ? errno : ENOSPC;
      // A piece that stands half in the file goes out again; a file that cannot be cut has none.
      if (::ftruncate(handle_, before.st_size) != 0) errno = error;
      return problemOf(path_, error);
    }
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return std::nullopt;
}

std::optional<Problem> AppendFile::sync() {
  if (uninterrupted([&] { return ::fdatasync(handle_); }) != 0 && errno != EINVAL && errno != EROFS) return problemOf(path_, errno);
  if (!std::exchange(made_, false)) return std::nullopt;
  const std::filesystem::path folder = path_.has_parent_path() ? path_.parent_path() : std::filesystem::path(".");
  if (const int opened = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); opened >= 0) {
    ::fsync(opened);
    ::close(opened);
  }
  return std::nullopt;
}

std::optional<Problem> AppendFile::cut(std::uintmax_t bytes) {
  if (uninterrupted([&] { return ::ftruncate(handle_, static_cast<off_t>(bytes)); }) != 0) return problemOf(path_, errno);
  return std::nullopt;
}

}  // namespace moltact
