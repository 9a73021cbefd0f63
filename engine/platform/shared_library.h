// An optional shared library, loaded at run time with dlopen. It is never unloaded, because some drivers fail when
// loaded a second time. Not for the haptic thread.
#pragma once

#include <span>
#include <string>

#include "engine/core/problem.h"

namespace moltact {

class SharedLibrary {
 public:
  /// Loads the first of `names` that exists, by the system's search or as a path. A Problem contains the loader's
  /// message for the first file that exists but cannot be loaded, else for the first name.
  static Expected<SharedLibrary> open(std::span<const std::string> names);

  /// The address of a function, or nullptr.
  void* symbol(const char* name) const;

 private:
  explicit SharedLibrary(void* handle) : handle_(handle) {}
  void* handle_;
};

}  // namespace moltact
