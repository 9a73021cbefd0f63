#include "engine/platform/folders.h"

#include <cstdlib>

namespace moltact {
namespace fs = std::filesystem;
namespace {

fs::path fromEnvironment(const char* name) {
  const char* value = std::getenv(name);
  return value ? fs::path(value) : fs::path();
}

bool holdsMolecules(const fs::path& folder) {
  std::error_code error;
  return fs::is_regular_file(folder / "molecules" / "catalogue.json", error);
}

}  // namespace

fs::path homeFolder() {
  const fs::path set = fromEnvironment("MOLTACT_HOME");
  if (!set.empty()) return set;
  std::error_code error;
  const fs::path beside = fs::read_symlink("/proc/self/exe", error).parent_path();
  if (!error)
    for (const fs::path& folder : {beside, beside.parent_path() / "share" / "moltact"})
      if (holdsMolecules(folder)) return folder;
  return MOLTACT_SOURCE_FOLDER;
}

fs::path moleculesFolder() { return homeFolder() / "molecules"; }
fs::path lessonsFolder() { return homeFolder() / "lessons"; }
fs::path assetsFolder() { return homeFolder() / "assets"; }

fs::path userDataFolder() {
  // The XDG base directory specification says that a relative path is to be ignored.
  const fs::path data = fromEnvironment("XDG_DATA_HOME");
  if (data.is_absolute()) return data / "moltact";
  const fs::path home = fromEnvironment("HOME");
  return home.empty() ? fs::path() : home / ".local" / "share" / "moltact";
}

fs::path userMoleculesFolder() {
  const fs::path data = userDataFolder();
  return data.empty() ? fs::path() : data / "molecules";
}

}  // namespace moltact
