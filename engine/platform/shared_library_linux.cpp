#include <dlfcn.h>

#include "engine/platform/shared_library.h"

namespace moltact {

Expected<SharedLibrary> SharedLibrary::open(std::span<const std::string> names) {
  std::string why;
  for (const std::string& name : names) {
    // Lazily: what the library lacks and nobody calls does not matter.
    if (void* handle = dlopen(name.c_str(), RTLD_LAZY | RTLD_LOCAL)) return SharedLibrary(handle);
    const char* reason = dlerror();
    // The first reason that is more than "no such file" says most: a library that is there but cannot be loaded.
    const std::string text = reason ? reason : "";
    if (why.empty() || text.find("No such file") == std::string::npos) why = text;
  }
  return Problem{names.empty() ? "" : names.front(), 0, 0, why, ""};
}

void* SharedLibrary::symbol(const char* name) const { return dlsym(handle_, name); }

}  // namespace moltact
