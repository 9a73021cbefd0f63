#include "engine/platform/folders.h"

#include <cstdlib>

namespace moltact {
namespace fs = std::filesystem;
namespace {

bool holdsMolecules(const fs::path& folder) {
  std::error_code error;
  return fs::is_regular_file(folder / "molecules" / "catalogue.json", error);
}

}  // namespace

fs::path homeFolder() {
  std::error_code ignored;
  // Only for the program's own data; a relative path refers to the working folder at the start.
  if (const char* set = std::getenv("MOLTACT_HOME"); set && *set) return fs::absolute(set, ignored);
  const fs::path beside = executablesFolder();
  const fs::path installed = beside.empty() ? beside : (beside / MOLTACT_DATA_FROM_PROGRAM).lexically_normal();
  for (const fs::path& folder : {beside, installed})
    if (!folder.empty() && holdsMolecules(folder)) return folder;
#ifdef MOLTACT_SOURCE_FOLDER
  return MOLTACT_SOURCE_FOLDER;
#else
  return installed;
#endif
}

std::vector<fs::path> sharedDataFolders() {
  std::vector<fs::path> out;
  for (const fs::path& of_system : systemDataFolders()) {
    const fs::path folder = (of_system / "moltact").lexically_normal();
    std::error_code error;
    if (folder.is_absolute() && !fs::equivalent(folder, homeFolder(), error)) out.push_back(folder);
  }
  return out;
}

fs::path moleculesFolder() { return homeFolder() / "molecules"; }
fs::path lessonsFolder() { return homeFolder() / "lessons"; }
fs::path assetsFolder() { return homeFolder() / "assets"; }

fs::path translationsFolder() {
  std::error_code error;
  for (const fs::path& folder : {homeFolder(), executablesFolder()})
    if (!folder.empty() && fs::is_directory(folder / "translations", error)) return folder / "translations";
#ifdef MOLTACT_BUILD_FOLDER
  return fs::path(MOLTACT_BUILD_FOLDER) / "translations";
#else
  return homeFolder() / "translations";
#endif
}

std::vector<fs::path> moduleFiles(const std::string& name) {
  const std::string file = name + ".so";
  std::vector<fs::path> out;
  if (const fs::path beside = executablesFolder(); !beside.empty()) {
    out.push_back(beside / "modules" / file);
    out.push_back((beside / MOLTACT_MODULES_FROM_PROGRAM / file).lexically_normal());
  }
#ifdef MOLTACT_BUILD_FOLDER
  out.push_back(fs::path(MOLTACT_BUILD_FOLDER) / "modules" / file);
#endif
  return out;
}

std::vector<fs::path> programFiles(const std::string& name) {
#ifdef _WIN32
  const std::string file = name + ".exe";
#else
  const std::string& file = name;
#endif
  std::vector<fs::path> out;
  if (const fs::path beside = executablesFolder(); !beside.empty()) {
    out.push_back(beside / file);
    out.push_back((beside / MOLTACT_MODULES_FROM_PROGRAM / file).lexically_normal());
  }
  return out;
}

fs::path browserEdition() {
  std::error_code error;
#ifdef MOLTACT_BUILD_FOLDER
  for (const fs::path& folder : {homeFolder(), fs::path(MOLTACT_BUILD_FOLDER).parent_path() / "web"})
#else
  for (const fs::path& folder : {homeFolder()})
#endif
    if (fs::is_regular_file(folder / "moltact.html", error)) return folder / "moltact.html";
  return {};
}

fs::path userDataFolder() {
  const fs::path data = folderFromEnvironment("XDG_DATA_HOME");
  if (!data.empty()) return data / "moltact";
  const fs::path home = folderFromEnvironment("HOME");
  return home.empty() ? fs::path() : home / ".local" / "share" / "moltact";
}

fs::path userMoleculesFolder() {
  const fs::path data = userDataFolder();
  return data.empty() ? fs::path() : data / "molecules";
}

}  // namespace moltact
