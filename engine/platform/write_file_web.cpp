// Whole files in the page's own memory (storage_web.h).
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <string>
#include <utility>

#include "engine/platform/storage_web.h"
#include "engine/platform/write_file.h"

namespace moltact {
namespace fs = std::filesystem;
using namespace platform;

struct Draft::Impl {
  fs::path file, draft;
  int handle = -1;
  bool refuse = false;

  ~Impl() {
    if (handle >= 0) ::close(handle);
    if (!draft.empty()) ::unlink(draft.c_str());
  }
};

Draft::Draft(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Draft::Draft(Draft&&) noexcept = default;
Draft& Draft::operator=(Draft&&) noexcept = default;
Draft::~Draft() = default;

Expected<Draft> Draft::begin(const fs::path& file, IfThere there) {
  auto impl = std::make_unique<Impl>();
  impl->file = file;
  impl->refuse = there == IfThere::Refuse;
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
  return Draft(std::move(impl));
}

std::optional<Problem> Draft::append(std::string_view bytes) {
  if (::write(impl_->handle, bytes.data(), bytes.size()) == ssize_t(bytes.size())) return std::nullopt;
  return storageProblem(impl_->file, errno);
}

const fs::path& Draft::path() const { return impl_->draft; }

std::optional<Problem> Draft::flush() { return std::nullopt; }

std::optional<Problem> Draft::commit() {
  Impl& w = *impl_;
  struct stat is {};
  if (w.refuse && ::stat(w.file.c_str(), &is) == 0) return storageProblem(w.file, EEXIST);
  if (::rename(w.draft.c_str(), w.file.c_str()) != 0) return storageProblem(w.file, errno);
  w.draft.clear();
  storageChanged();
  return std::nullopt;
}

void takeSizeLimitsAsErrors() {}

}  // namespace moltact
