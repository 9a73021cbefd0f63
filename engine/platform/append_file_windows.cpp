#include <windows.h>

#include "engine/platform/append_file.h"
#include "engine/platform/writing_calls_windows.h"

namespace moltact {

using namespace platform;

namespace {
// Kernel handles have 32 significant bits, also in a 64-bit program.
HANDLE handleOf(int number) { return LongToHandle(number); }
}  // namespace

Expected<AppendFile> AppendFile::openInSystem(const std::filesystem::path& path, Begin begin) {
  AppendFile file(path, -1);
  if (begin == Begin::Replace) {
    // Tests whether another program is writing the file to be replaced.
    if (void* const old = openToWrite(path, Make::Nothing))
      CloseHandle(old);
    else if (GetLastError() == ERROR_SHARING_VIOLATION)
      return writingProblem(path, ERROR_SHARING_VIOLATION);
  }
  void* const handle = begin == Begin::Replace ? openDraft(path, file.empty_)
                                               : openToWrite(path, begin == Begin::New ? Make::NewFile : Make::Nothing);
  if (!handle) {
    file.empty_.clear();
    return writingProblem(path, GetLastError());
  }
  file.handle_ = int(HandleToLong(handle));
  if (begin == Begin::New) file.empty_ = path;
  return file;
}

AppendFile::~AppendFile() {
  if (handle_ != -1) CloseHandle(handleOf(handle_));
  if (!empty_.empty()) DeleteFileW(empty_.c_str());
}

std::optional<Problem> AppendFile::append(std::string_view bytes) {
  if (bytes.empty()) return std::nullopt;
  LARGE_INTEGER before{};
  if (!GetFileSizeEx(handleOf(handle_), &before)) return writingProblem(path_, GetLastError());
  const auto failed = [&] {
    const DWORD error = GetLastError();
    cutTo(handleOf(handle_), std::size_t(before.QuadPart));  // removes a partly written piece
    return writingProblem(path_, error);
  };
  if (!writeAtEnd(handleOf(handle_), bytes)) return failed();
  // The replaced file is complete; it must not be replaced by a name without its bytes.
  if (!empty_.empty() && empty_ != path_ && (!FlushFileBuffers(handleOf(handle_)) || !placeDraft(empty_, path_, false)))
    return failed();
  empty_.clear();
  return std::nullopt;
}

std::optional<Problem> AppendFile::sync() {
  if (!FlushFileBuffers(handleOf(handle_))) return writingProblem(path_, GetLastError());
  return std::nullopt;
}

std::optional<Problem> AppendFile::cut(std::uintmax_t bytes) {
  if (!cutTo(handleOf(handle_), std::size_t(bytes))) return writingProblem(path_, GetLastError());
  return std::nullopt;
}

}  // namespace moltact
