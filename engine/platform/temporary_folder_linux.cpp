#include <fcntl.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <system_error>
#include <vector>

#include "engine/language/catalogue.h"
#include "engine/platform/temporary_folder.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

int openFolder(const fs::path& folder) {
  return ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
}

// True if the handle belongs to the folder at the path.
bool isAtPath(int handle, const fs::path& path) {
  struct stat a {
  }, b{};
  return ::fstat(handle, &a) == 0 && ::lstat(path.c_str(), &b) == 0 && a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

}  // namespace

Expected<TemporaryFolder> TemporaryFolder::in(const fs::path& folder, std::string_view prefix) {
  // Another program may remove the new folder as an orphan until it is locked; then another is created.
  for (int tries = 0; tries < 10; ++tries) {
    std::string name = (folder / prefix).string() + "XXXXXX";
    if (!::mkdtemp(name.data())) break;
    const int lock = openFolder(name);
    if (lock < 0 && errno == ENOENT) continue;
    const bool busy = lock >= 0 && ::flock(lock, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    if (!busy && (lock < 0 || isAtPath(lock, name))) return TemporaryFolder(std::move(name), lock);
    ::close(lock);
  }
  return Problem{folder.string(), 0, 0, trf("no folder can be made in it: {0}", std::strerror(errno)),
                 tr("check that you may write there and that the disk has room")};
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
  if (lock_ >= 0) ::close(lock_);
}

void sweepTemporaryFolders(const fs::path& folder, std::string_view prefix) {
  std::error_code error, ignored;
  std::vector<fs::path> found;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    if (it->path().filename().string().starts_with(prefix)) found.push_back(it->path());
  for (const fs::path& path : found) {
    const int handle = openFolder(path);
    struct stat is {};
    if (handle >= 0 && ::fstat(handle, &is) == 0 && is.st_uid == ::geteuid() &&
        ::flock(handle, LOCK_EX | LOCK_NB) == 0 && isAtPath(handle, path))
      fs::remove_all(path, ignored);
    if (handle >= 0) ::close(handle);
  }
}

}  // namespace moltact
