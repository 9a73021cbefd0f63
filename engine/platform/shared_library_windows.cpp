#include <windows.h>

#include <filesystem>
#include <system_error>

#include "engine/language/catalogue.h"
#include "engine/platform/shared_library.h"

namespace moltact {

Expected<SharedLibrary> SharedLibrary::open(std::span<const std::string> names) {
  std::string why, missing;
  for (const std::string& name : names) {
    if (HMODULE const handle = LoadLibraryW(std::filesystem::path(name).c_str()))
      return SharedLibrary(reinterpret_cast<void*>(handle));
    const DWORD error = GetLastError();
    const std::string text = trf("{0} cannot be loaded: {1}", name, std::system_category().message(int(error)));
    // A library that exists but cannot be loaded is more informative than missing ones: the first such one is reported.
    std::string& into = error == ERROR_MOD_NOT_FOUND ? missing : why;
    if (into.empty()) into = text;
  }
  return Problem{names.empty() ? "" : names.front(), 0, 0, why.empty() ? missing : why, ""};
}

void* SharedLibrary::symbol(const char* name) const {
  return reinterpret_cast<void*>(GetProcAddress(static_cast<HMODULE>(handle_), name));
}

}  // namespace moltact
