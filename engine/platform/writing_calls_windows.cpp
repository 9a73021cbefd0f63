#include "engine/platform/writing_calls_windows.h"

#include <windows.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <string>
#include <system_error>

#include "engine/language/catalogue.h"

namespace moltact::platform {
namespace fs = std::filesystem;
namespace {

// As on other systems: ".moltact-1f9b03c2-" and the end of the file's own name, whose ending readers use.
constexpr std::wstring_view kDraft = L".moltact-";
constexpr std::size_t kDigits = 8, kNameKept = 60;

fs::path folderOf(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

std::wstring draftName(const fs::path& file) {
  static std::uint32_t count = 0;
  const auto now = std::uint32_t(std::chrono::steady_clock::now().time_since_epoch().count());
  wchar_t digits[kDigits + 1];
  std::swprintf(digits, kDigits + 1, L"%08x", now ^ (GetCurrentProcessId() << 12) ^ ++count);
  const std::wstring name = file.filename().native();
  return std::wstring(kDraft) + digits + L'-' + name.substr(name.size() - std::min(name.size(), kNameKept));
}

bool isDraftName(std::wstring_view name) {
  if (!name.starts_with(kDraft) || name.size() <= kDraft.size() + kDigits || name[kDraft.size() + kDigits] != L'-')
    return false;
  return name.substr(kDraft.size(), kDigits).find_first_not_of(L"0123456789abcdef") == std::wstring_view::npos;
}

// A draft that can be opened for writing belongs to no running program.
void removeOrphans(const fs::path& folder) {
  std::error_code error;
  fs::directory_iterator it(folder, error);
  for (; !error && it != fs::directory_iterator(); it.increment(error)) {
    if (!isDraftName(it->path().filename().native())) continue;
    HANDLE const handle = CreateFileW(it->path().c_str(), GENERIC_WRITE | DELETE, 0, nullptr, OPEN_EXISTING,
                                      FILE_FLAG_DELETE_ON_CLOSE, nullptr);
    if (handle != INVALID_HANDLE_VALUE) CloseHandle(handle);
  }
}

}  // namespace

Problem writingProblem(const fs::path& path, unsigned long error) {
  Problem p{path.string(), 0, 0, {}, {}};
  switch (error) {
    case ERROR_DISK_FULL:
    case ERROR_HANDLE_DISK_FULL:
      p.message = tr("the disk is full");
      p.remedy = tr("free some space on it");
      break;
    case ERROR_ACCESS_DENIED:
    case ERROR_WRITE_PROTECT:
      p.message = tr("it may not be written");
      p.remedy = tr("allow writing to it and to its folder");
      break;
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND:
    case ERROR_BAD_NETPATH:
      p.message = tr("its folder is not there");
      p.remedy = tr("make the folder");
      break;
    case ERROR_FILE_EXISTS:
    case ERROR_ALREADY_EXISTS:
      p.message = tr("it is already there");
      break;
    case ERROR_DIRECTORY:
      p.message = tr("it is a folder");
      p.remedy = tr("name a file");
      break;
    case ERROR_FILENAME_EXCED_RANGE:
      p.message = tr("its name is too long");
      p.remedy = tr("choose a shorter one");
      break;
    case ERROR_SHARING_VIOLATION:
    case ERROR_LOCK_VIOLATION:
      p.message = tr("another Moltact is writing it");
      p.remedy = tr("close the other window");
      break;
    default:
      p.message = trf("it cannot be written ({0})", std::system_category().message(int(error)));
      p.remedy = tr("check the disk");
  }
  return p;
}

void* openToWrite(const fs::path& file, Make make) {
  HANDLE const handle =
      CreateFileW(file.c_str(), GENERIC_READ | GENERIC_WRITE, FILE_SHARE_READ | FILE_SHARE_DELETE, nullptr,
                  make == Make::NewFile ? CREATE_NEW : OPEN_EXISTING, FILE_ATTRIBUTE_NORMAL, nullptr);
  return handle == INVALID_HANDLE_VALUE ? nullptr : handle;
}

void* openDraft(const fs::path& file, fs::path& draft) {
  const fs::path folder = folderOf(file);
  if (const DWORD is = GetFileAttributesW(file.c_str());
      is != INVALID_FILE_ATTRIBUTES && is & FILE_ATTRIBUTE_READONLY) {
    SetLastError(ERROR_ACCESS_DENIED);  // a file without write permission is not replaced either
    return nullptr;
  }
  removeOrphans(folder);
  for (int tries = 0; tries < 100; ++tries) {
    draft = folder / draftName(file);
    if (void* const handle = openToWrite(draft, Make::NewFile)) return handle;
    if (GetLastError() != ERROR_FILE_EXISTS) return nullptr;
  }
  return nullptr;
}

bool placeDraft(const fs::path& draft, const fs::path& file, bool refuse) {
  const DWORD how = MOVEFILE_WRITE_THROUGH | (refuse ? 0 : MOVEFILE_REPLACE_EXISTING);
  return MoveFileExW(draft.c_str(), file.c_str(), how) != 0;
}

bool writeAtEnd(void* handle, std::string_view bytes) {
  LARGE_INTEGER none{};
  if (!SetFilePointerEx(handle, none, nullptr, FILE_END)) return false;
  while (!bytes.empty()) {
    constexpr std::size_t kMax = std::size_t{1} << 30;
    DWORD written = 0;
    if (!WriteFile(handle, bytes.data(), DWORD(std::min(bytes.size(), kMax)), &written, nullptr)) return false;
    if (written == 0) {
      SetLastError(ERROR_DISK_FULL);
      return false;
    }
    bytes.remove_prefix(written);
  }
  return true;
}

bool cutTo(void* handle, std::size_t bytes) {
  LARGE_INTEGER at{};
  at.QuadPart = LONGLONG(bytes);
  return SetFilePointerEx(handle, at, nullptr, FILE_BEGIN) && SetEndOfFile(handle);
}

}  // namespace moltact::platform
