#include <windows.h>

#include <string>
#include <utility>

#include "engine/platform/draft_impl.h"
#include "engine/platform/writing_calls_windows.h"

namespace moltact {
namespace fs = std::filesystem;
using namespace platform;

namespace {

struct SystemDraft final : Draft::Impl {
  fs::path file;
  void* handle = nullptr;
  bool refuse = false;

  ~SystemDraft() override {
    if (handle) CloseHandle(handle);
    if (!draft.empty()) DeleteFileW(draft.c_str());
  }
  std::optional<Problem> write(std::string_view bytes) override {
    if (!writeAtEnd(handle, bytes)) return writingProblem(file, GetLastError());
    return std::nullopt;
  }
  std::optional<Problem> place() override {
    if (!FlushFileBuffers(handle) || !placeDraft(draft, file, refuse)) return writingProblem(file, GetLastError());
    draft.clear();
    return std::nullopt;
  }
};

}  // namespace

Expected<std::unique_ptr<Draft::Impl>> Draft::Impl::begin(const fs::path& file, bool refuse) {
  auto impl = std::make_unique<SystemDraft>();
  impl->file = file;
  impl->refuse = refuse;
  const DWORD is = GetFileAttributesW(file.c_str());
  const bool exists = is != INVALID_FILE_ATTRIBUTES;
  if (exists && is & FILE_ATTRIBUTE_DIRECTORY) return writingProblem(file, ERROR_DIRECTORY);
  if (exists && impl->refuse) return writingProblem(file, ERROR_ALREADY_EXISTS);
  impl->handle = openDraft(file, impl->draft);
  if (!impl->handle) {
    impl->draft.clear();
    return writingProblem(file, GetLastError());
  }
  return std::unique_ptr<Impl>(std::move(impl));
}

// Windows limits file sizes only by the disk.
void takeSizeLimitsAsErrors() {}

}  // namespace moltact
