#include <cstdlib>

#include "engine/platform/folders.h"

namespace moltact {
namespace fs = std::filesystem;

fs::path executablesFolder() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  return error ? fs::path() : program.parent_path();
}

fs::path folderFromEnvironment(const char* name) {
  const char* value = std::getenv(name);
  const fs::path folder = value ? fs::path(value) : fs::path();
  return folder.is_absolute() ? folder : fs::path();
}

}  // namespace moltact
