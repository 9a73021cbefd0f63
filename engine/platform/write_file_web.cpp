// Whole files in the page's own memory (storage_web.h).
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <string>
#include <utility>

#include "engine/platform/draft_impl.h"
#include "engine/platform/storage_web.h"

namespace moltact {
namespace fs = std::filesystem;
using namespace platform;

namespace {

struct SystemDraft final : Draft::Impl {
  fs::path file;
  int handle = -1;
  bool refuse = false;

  ~SystemDraft() override {
    if (handle >= 0) ::close(handle);
    if (!draft.empty()) ::unlink(draft.c_str());
  }
  std::optional<Problem> write(std::string_view bytes) override {
    if (::write(handle, bytes.data(), bytes.size()) == ssize_t(bytes.size())) return std::nullopt;
    return storageProblem(file, errno);
  }
  std::optional<Problem> place() override {
    struct stat is {};
    if (refuse && ::stat(file.c_str(), &is) == 0) return storageProblem(file, EEXIST);
    if (::rename(draft.c_str(), file.c_str()) != 0) return storageProblem(file, errno);
    draft.clear();
    storageChanged();
    return std::nullopt;
  }
};

}  // namespace

Expected<std::unique_ptr<Draft::Impl>> Draft::Impl::begin(const fs::path& file, bool refuse) {
  auto impl = std::make_unique<SystemDraft>();
  impl->file = file;
  impl->refuse = refuse;
  struct stat is {};
  const bool exists = ::stat(file.c_str(), &is) == 0;
  if (exists && S_ISDIR(is.st_mode)) return storageProblem(file, EISDIR);
  if (exists && impl->refuse) return storageProblem(file, EEXIST);
  static int number = 0;
  impl->draft = file.parent_path() / (".moltact-" + std::to_string(++number) + "-" + file.filename().string());
  impl->handle = ::open(impl->draft.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
  if (impl->handle < 0) {
    const int error = errno;
    impl->draft.clear();
    return storageProblem(file, error);
  }
  return std::unique_ptr<Impl>(std::move(impl));
}

void takeSizeLimitsAsErrors() {}

}  // namespace moltact
