#include "engine/language/catalogue.h"
#include "engine/platform/shared_library.h"

namespace moltact {

Expected<SharedLibrary> SharedLibrary::open(std::span<const std::string> names) {
  const std::string name = names.empty() ? std::string() : names.front();
  return Problem{name, 0, 0, trf("{0} cannot be loaded", name), ""};
}

void* SharedLibrary::symbol(const char*) const { return nullptr; }

}  // namespace moltact
