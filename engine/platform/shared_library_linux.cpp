#include <dlfcn.h>

#include "engine/language/catalogue.h"
#include "engine/platform/shared_library.h"

namespace moltact {

Expected<SharedLibrary> SharedLibrary::open(std::span<const std::string> names) {
  std::string why, missing;
  for (const std::string& name : names) {
    // Lazy binding: missing symbols do not matter unless they are used.
    if (void* handle = dlopen(name.c_str(), RTLD_LAZY | RTLD_LOCAL)) return SharedLibrary(handle);
    const char* reason = dlerror();
    const std::string text = reason ? reason : trf("{0} cannot be loaded", name);
    // A library that exists but cannot be loaded is more informative than missing ones: the first such one is reported.
    // The message "no such file" may also refer to another library that it needs.
    if (text.starts_with(name + ": cannot open shared object file: No such file")) {
      if (missing.empty()) missing = text;
    } else if (why.empty()) {
      why = text.starts_with(name) ? text : trf("{0} cannot be loaded: {1}", name, text);
    }
  }
  return Problem{names.empty() ? "" : names.front(), 0, 0, why.empty() ? missing : why, ""};
}

void* SharedLibrary::symbol(const char* name) const { return dlsym(handle_, name); }

}  // namespace moltact
