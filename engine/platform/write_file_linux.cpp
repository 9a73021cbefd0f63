#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <string>
#include <utility>

#include "engine/platform/draft_calls_linux.h"
#include "engine/platform/write_file.h"

namespace moltact {
namespace fs = std::filesystem;
using namespace platform;

struct Draft::Works {
  fs::path named, file, draft;  // as the person named it, behind its links, and beside that
  int handle = -1;
  bool refuse = false, whole = true;  // a pipe or a device is written to as it is: no draft
  std::string waiting;

  ~Works() {
    if (handle >= 0) ::close(handle);
    if (!draft.empty() && whole) ::unlink(draft.c_str());
  }
  Problem problem(int error) const { return writingProblem(named, error); }
  std::optional<Problem> send() {
    std::string_view bytes = waiting;
    while (!bytes.empty()) {
      const ssize_t written = uninterrupted([&] { return ::write(handle, bytes.data(), bytes.size()); });
      if (written <= 0) return problem(written < 0 ? errno : ENOSPC);
      bytes.remove_prefix(std::size_t(written));
    }
    waiting.clear();
    return std::nullopt;
  }
};

Draft::Draft(std::unique_ptr<Works> works) : works_(std::move(works)) {}
Draft::Draft(Draft&&) noexcept = default;
Draft& Draft::operator=(Draft&&) noexcept = default;
Draft::~Draft() = default;

Expected<Draft> Draft::begin(const fs::path& file, IfThere there) {
  auto works = std::make_unique<Works>();
  works->named = file;
  works->refuse = there == IfThere::Refuse;
  struct stat is {};
  const bool exists = ::stat(file.c_str(), &is) == 0;
  if (exists && S_ISDIR(is.st_mode)) return works->problem(EISDIR);
  if (works->refuse && ::lstat(file.c_str(), &is) == 0) return works->problem(EEXIST);
  if (exists && !S_ISREG(is.st_mode)) {
    works->whole = false;
    works->draft = file;
    works->handle = uninterrupted([&] { return ::open(file.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY); });
  } else {
    works->file = behindLinks(file);
    works->handle = openDraft(works->file, O_WRONLY, works->draft);
    if (works->handle < 0) works->draft.clear();
  }
  if (works->handle < 0) return works->problem(errno);
  return Draft(std::move(works));
}

std::optional<Problem> Draft::append(std::string_view bytes) {
  constexpr std::size_t kMostWaiting = std::size_t{1} << 20;
  works_->waiting += bytes;
  return works_->waiting.size() < kMostWaiting ? std::nullopt : works_->send();
}

const fs::path& Draft::path() const { return works_->draft; }

std::optional<Problem> Draft::flush() { return works_->send(); }

std::optional<Problem> Draft::commit() {
  Works& w = *works_;
  if (auto problem = w.send()) return problem;
  if (!w.whole) return std::nullopt;
  if (syncData(w.handle) != 0) return w.problem(errno);
  if (placeDraft(w.draft, w.file, w.refuse) != 0) return w.problem(errno);
  w.draft.clear();
  syncName(w.file);
  return std::nullopt;
}

std::optional<Problem> writeWhole(const fs::path& file, std::string_view bytes, IfThere there) {
  Expected<Draft> draft = Draft::begin(file, there);
  if (!draft) return draft.problem();
  if (auto problem = draft->append(bytes)) return problem;
  return draft->commit();
}

void takeSizeLimitsAsErrors() { std::signal(SIGXFSZ, SIG_IGN); }

}  // namespace moltact
