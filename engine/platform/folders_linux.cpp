#include <cstdlib>
#include <sstream>
#include <string>

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

std::vector<fs::path> systemDataFolders() {
  const char* set = std::getenv("XDG_DATA_DIRS");
  std::istringstream listed(set && *set ? set : "/usr/local/share:/usr/share");
  std::vector<fs::path> out;
  for (std::string name; std::getline(listed, name, ':');) out.emplace_back(name);
  return out;
}

}  // namespace moltact
