#include <windows.h>

#include <string>
#include <utility>

#include "engine/platform/write_file.h"
#include "engine/platform/writing_calls_windows.h"

namespace moltact {
namespace fs = std::filesystem;
using namespace platform;

struct Draft::Impl {
  fs::path file, draft;
  void* handle = nullptr;
  bool refuse = false;
  std::string waiting;

  ~Impl() {
    if (handle) CloseHandle(handle);
    if (!draft.empty()) DeleteFileW(draft.c_str());
  }
  std::optional<Problem> send() {
    if (!writeAtEnd(handle, waiting)) return writingProblem(file, GetLastError());
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
  impl->file = file;
  impl->refuse = there == IfThere::Refuse;
  const DWORD is = GetFileAttributesW(file.c_str());
  const bool exists = is != INVALID_FILE_ATTRIBUTES;
  if (exists && is & FILE_ATTRIBUTE_DIRECTORY) return writingProblem(file, ERROR_DIRECTORY);
  if (exists && impl->refuse) return writingProblem(file, ERROR_ALREADY_EXISTS);
  impl->handle = openDraft(file, impl->draft);
  if (!impl->handle) {
    impl->draft.clear();
    return writingProblem(file, GetLastError());
  }
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
  if (!FlushFileBuffers(w.handle) || !placeDraft(w.draft, w.file, w.refuse))
    return writingProblem(w.file, GetLastError());
  w.draft.clear();
  return std::nullopt;
}

// Windows has no such limits but those of the disk.
void takeSizeLimitsAsErrors() {}

}  // namespace moltact
