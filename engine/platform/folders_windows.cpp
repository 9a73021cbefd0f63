#include <windows.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "engine/platform/folders.h"

namespace moltact {
namespace fs = std::filesystem;
namespace {

fs::path variable(const wchar_t* name) {
  std::wstring value(32768, L'\0');  // the maximum length
  value.resize(GetEnvironmentVariableW(name, value.data(), DWORD(value.size())));
  return value;
}

// The Windows equivalents of the folders of the XDG base directory specification.
constexpr std::pair<std::string_view, const wchar_t*> kNamedHere[] = {{"HOME", L"USERPROFILE"},
                                                                      {"XDG_DATA_HOME", L"LOCALAPPDATA"},
                                                                      {"XDG_CONFIG_HOME", L"APPDATA"},
                                                                      {"XDG_CACHE_HOME", L"TEMP"}};

}  // namespace

fs::path executablesFolder() {
  std::wstring file(32768, L'\0');
  file.resize(GetModuleFileNameW(nullptr, file.data(), DWORD(file.size())));
  return fs::path(file).parent_path();
}

fs::path folderFromEnvironment(const char* name) {
  fs::path folder = variable(fs::path(name).c_str());
  for (const auto& [there, here] : kNamedHere)
    if (folder.empty() && there == name) folder = variable(here);
  return folder.is_absolute() ? folder : fs::path();
}

std::vector<fs::path> systemDataFolders() {
  std::wstring listed = variable(L"XDG_DATA_DIRS").native();
  if (listed.empty()) listed = variable(L"ProgramData").native();
  std::vector<fs::path> out;
  for (std::wstring_view rest = listed; !rest.empty();) {
    const std::size_t end = std::min(rest.find(L';'), rest.size());
    out.emplace_back(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return out;
}

}  // namespace moltact
