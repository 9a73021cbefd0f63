// Files that grow, in the page's own memory (storage_web.h): there is one program, no shared folder and no disk to wait
// for.
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

#include "engine/platform/append_file.h"
#include "engine/platform/storage_web.h"

namespace moltact {

using namespace platform;

Expected<AppendFile> AppendFile::openInSystem(const std::filesystem::path& path, Begin begin) {
  AppendFile file(path, -1);
  const int how = begin == Begin::New ? O_CREAT | O_EXCL : begin == Begin::Replace ? O_CREAT : 0;
  file.handle_ = ::open(path.c_str(), O_WRONLY | O_APPEND | how, 0666);
  if (file.handle_ < 0) return storageProblem(path, errno);
  if (begin == Begin::New) file.empty_ = path;
  file.unsynced_name_ = begin == Begin::Replace;  // the first piece replaces the content
  return file;
}

AppendFile::~AppendFile() {
  if (!empty_.empty()) ::unlink(empty_.c_str());
  if (handle_ >= 0) ::close(handle_);
}

std::optional<Problem> AppendFile::append(std::string_view bytes) {
  if (bytes.empty()) return std::nullopt;
  if (std::exchange(unsynced_name_, false) && ::ftruncate(handle_, 0) != 0) return storageProblem(path_, errno);
  struct stat before {};
  if (::fstat(handle_, &before) != 0) return storageProblem(path_, errno);
  if (::write(handle_, bytes.data(), bytes.size()) != ssize_t(bytes.size())) {
    const int error = errno;
    (void)!::ftruncate(handle_, before.st_size);
    return storageProblem(path_, error);
  }
  empty_.clear();
  storageChanged();
  return std::nullopt;
}

std::optional<Problem> AppendFile::sync() {
  storageChanged();
  return std::nullopt;
}

std::optional<Problem> AppendFile::cut(std::uintmax_t bytes) {
  if (::ftruncate(handle_, static_cast<off_t>(bytes)) != 0) return storageProblem(path_, errno);
  storageChanged();
  return std::nullopt;
}

}  // namespace moltact
