// A shared library that is loaded at run time and may be missing. Uses dlopen. It is never unloaded, for some drivers
// fail when they are loaded a second time. Not for the haptic thread.
#pragma once

#include <span>
#include <string>

#include "engine/core/problem.h"

namespace moltact {

class SharedLibrary {
 public:
  /// Loads the first of `names` that is found, by the system's own search or as a path. A Problem in the loader's
  /// words: of the first that is there and cannot be loaded, else of the first.
  static Expected<SharedLibrary> open(std::span<const std::string> names);

  /// The address of a function, or nullptr.
  void* symbol(const char* name) const;

 private:
  explicit SharedLibrary(void* handle) : handle_(handle) {}
  void* handle_;
};

}  // namespace moltact
