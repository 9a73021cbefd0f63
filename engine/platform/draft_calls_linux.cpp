#include "engine/platform/draft_calls_linux.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>

#include "engine/language/catalogue.h"

namespace moltact::platform {
namespace fs = std::filesystem;
namespace {

// ".moltact-1f9b03c2-" and the end of the file's own name, whose ending readers use.
constexpr std::string_view kDraft = ".moltact-";
constexpr std::size_t kDigits = 8, kNameKept = 60;

fs::path folderOf(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

std::string draftName(const fs::path& file) {
  std::uint32_t number = 0;
  if (::getrandom(&number, sizeof number, GRND_NONBLOCK) != ssize_t(sizeof number))
    number = std::uint32_t(std::chrono::steady_clock::now().time_since_epoch().count()) ^ std::uint32_t(::getpid())
                                                                                              << 12;
  char digits[kDigits + 1];
  std::snprintf(digits, sizeof digits, "%08x", number);
  const std::string name = file.filename().string();
  return std::string(kDraft) + digits + '-' + name.substr(name.size() - std::min(name.size(), kNameKept));
}

bool isDraftName(std::string_view name) {
  if (!name.starts_with(kDraft) || name.size() <= kDraft.size() + kDigits || name[kDraft.size() + kDigits] != '-')
    return false;
  const std::string_view digits = name.substr(kDraft.size(), kDigits);
  return digits.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

// An unlocked draft belongs to no running program.
void removeOrphans(const fs::path& folder) {
  std::error_code error;
  fs::directory_iterator it(folder, error);
  for (; !error && it != fs::directory_iterator(); it.increment(error)) {
    if (!isDraftName(it->path().filename().native())) continue;
    const int handle = ::open(it->path().c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (handle < 0) continue;
    struct stat is {};
    if (::fstat(handle, &is) == 0 && S_ISREG(is.st_mode) && ::flock(handle, LOCK_EX | LOCK_NB) == 0)
      ::unlink(it->path().c_str());
    ::close(handle);
  }
}

}  // namespace

Problem writingProblem(const fs::path& path, int error) {
  Problem p{path.string(), 0, 0, {}, {}};
  switch (error) {
    case ENOSPC:
    case EDQUOT:
      p.message = tr("the disk is full");
      p.remedy = tr("free some space on it");
      break;
    case EFBIG:
      p.message = tr("it would grow larger than files may be here");
      p.remedy = tr("raise that limit (ulimit -f), or write to another disk");
      break;
    case EROFS:
    case EACCES:
    case EPERM:
      p.message = tr("it may not be written");
      p.remedy = tr("allow writing to it and to its folder");
      break;
    case ENOENT:
    case ENOTDIR:
      p.message = tr("its folder is not there");
      p.remedy = tr("make the folder");
      break;
    case EEXIST:
      p.message = tr("it is already there");
      break;
    case EISDIR:
      p.message = tr("it is a folder");
      p.remedy = tr("name a file");
      break;
    case ENAMETOOLONG:
      p.message = tr("its name is too long");
      p.remedy = tr("choose a shorter one");
      break;
    case EWOULDBLOCK:
      p.message = tr("another Moltact is writing it");
      p.remedy = tr("close the other window");
      break;
    default:
      p.message = trf("it cannot be written ({0})", std::strerror(error));
      p.remedy = tr("check the disk");
  }
  return p;
}

fs::path behindLinks(const fs::path& file) {
  fs::path at = file;
  constexpr int kMax = 40;  // as in the kernel
  for (int k = 0; k < kMax; ++k) {
    std::error_code error;
    const fs::path to = fs::read_symlink(at, error);
    if (error) return at;
    at = to.is_absolute() ? to : folderOf(at) / to;
  }
  return at;
}

int openDraft(const fs::path& file, int flags, fs::path& draft) {
  const fs::path folder = folderOf(file);
  // A file without write permission is not replaced either.
  if (::access(file.c_str(), F_OK) == 0 && ::access(file.c_str(), W_OK) != 0) return -1;
  removeOrphans(folder);
  for (int tries = 0; tries < 100; ++tries) {
    draft = folder / draftName(file);
    const int handle = uninterrupted([&] { return ::open(draft.c_str(), flags | O_CREAT | O_EXCL | O_CLOEXEC, 0666); });
    if (handle < 0 && errno == EEXIST) continue;
    if (handle < 0) return -1;
    // File systems without locks (some network ones) are used without; there, no draft counts as an orphan.
    uninterrupted([&] { return ::flock(handle, LOCK_EX); });
    struct stat before {
    }, is{};
    if (::fstat(handle, &is) == 0 && is.st_nlink == 0) {  // another program removed it before it was locked
      ::close(handle);
      continue;
    }
    if (::stat(file.c_str(), &before) == 0) (void)::fchmod(handle, before.st_mode & 07777);
    return handle;
  }
  errno = EEXIST;
  return -1;
}

int placeDraft(const fs::path& draft, const fs::path& file, bool refuse) {
  if (!refuse) return ::rename(draft.c_str(), file.c_str());
  if (::renameat2(AT_FDCWD, draft.c_str(), AT_FDCWD, file.c_str(), RENAME_NOREPLACE) == 0) return 0;
  if (errno != EINVAL && errno != ENOSYS) return -1;
  if (::link(draft.c_str(), file.c_str()) != 0) return -1;
  ::unlink(draft.c_str());
  return 0;
}

int syncData(int handle) {
  if (uninterrupted([&] { return ::fdatasync(handle); }) == 0 || errno == EINVAL || errno == EROFS) return 0;
  return -1;
}

void syncName(const fs::path& file) {
  if (const int opened = ::open(folderOf(file).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); opened >= 0) {
    ::fsync(opened);
    ::close(opened);
  }
}

}  // namespace moltact::platform
