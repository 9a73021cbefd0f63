#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <string>
#include <utility>

#include "engine/platform/draft_calls_linux.h"
#include "engine/platform/draft_impl.h"

namespace moltact {
namespace fs = std::filesystem;
using namespace platform;

namespace {

struct SystemDraft final : Draft::Impl {
  fs::path named, file;  // as named by the caller, and with links resolved; the draft is beside the latter
  int handle = -1;
  bool refuse = false, whole = true;  // not whole: a pipe or a device, written without a draft

  ~SystemDraft() override {
    if (handle >= 0) ::close(handle);
    if (!draft.empty() && whole) ::unlink(draft.c_str());
  }
  Problem problem(int error) const { return writingProblem(named, error); }
  std::optional<Problem> write(std::string_view bytes) override {
    while (!bytes.empty()) {
      const ssize_t written = uninterrupted([&] { return ::write(handle, bytes.data(), bytes.size()); });
      if (written <= 0) return problem(written < 0 ? errno : ENOSPC);
      bytes.remove_prefix(std::size_t(written));
    }
    return std::nullopt;
  }
  std::optional<Problem> place() override {
    if (!whole) return std::nullopt;
    if (syncData(handle) != 0) return problem(errno);
    if (placeDraft(draft, file, refuse) != 0) return problem(errno);
    draft.clear();
    syncName(file);
    return std::nullopt;
  }
};

}  // namespace

Expected<std::unique_ptr<Draft::Impl>> Draft::Impl::begin(const fs::path& file, bool refuse) {
  auto impl = std::make_unique<SystemDraft>();
  impl->named = file;
  impl->refuse = refuse;
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
  return std::unique_ptr<Impl>(std::move(impl));
}

void takeSizeLimitsAsErrors() { std::signal(SIGXFSZ, SIG_IGN); }

}  // namespace moltact
