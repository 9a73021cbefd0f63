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

struct Draft::Impl {
  fs::path named, file, draft;  // as the person named it, behind its links, and beside that
  int handle = -1;
  bool refuse = false, whole = true;  // a pipe or a device is written to as it is: no draft
  std::string waiting;

  ~Impl() {
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

Draft::Draft(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Draft::Draft(Draft&&) noexcept = default;
Draft& Draft::operator=(Draft&&) noexcept = default;
Draft::~Draft() = default;

Expected<Draft> Draft::begin(const fs::path& file, IfThere there) {
  auto impl = std::make_unique<Impl>();
  impl->named = file;
  impl->refuse = there == IfThere::Refuse;
  struct stat is {};
  const bool exists = ::stat(file.c_str(), &is) == 0;
  if (exists && S_ISDIR(is.st_mode)) return impl->problem(EISDIR);
  if (impl->refuse && ::lstat(file.c_str(), &is) == 0) return impl->problem(EEXIST);
  if (exists && !S_ISREG(is.st_mode)) {
    impl->whole = false;
    impl->draft = file;
    impl->handle = uninterrupted([&] { return ::open(file.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY); });
  } else {
    impl->file = behindLinks(file);
    impl->handle = openDraft(impl->file, O_WRONLY, impl->draft);
    if (impl->handle < 0) impl->draft.clear();
  }
  if (impl->handle < 0) return impl->problem(errno);
  return Draft(std::move(impl));
}

std::optional<Problem> Draft::append(std::string_view bytes) {
  constexpr std::size_t kMostWaiting = std::size_t{1} << 20;
  impl_->waiting += bytes;
  return impl_->waiting.size() < kMostWaiting ? std::nullopt : impl_->send();
}

const fs::path& Draft::path() const { return impl_->draft; }

std::optional<Problem> Draft::flush() { return impl_->send(); }

std::optional<Problem> Draft::commit() {
  Impl& w = *impl_;
  if (auto problem = w.send()) return problem;
  if (!w.whole) return std::nullopt;
  if (syncData(w.handle) != 0) return w.problem(errno);
  if (placeDraft(w.draft, w.file, w.refuse) != 0) return w.problem(errno);
  w.draft.clear();
  syncName(w.file);
  return std::nullopt;
}

void takeSizeLimitsAsErrors() { std::signal(SIGXFSZ, SIG_IGN); }

}  // namespace moltact
