#include "app/ui/files/user_folders.h"

#include <system_error>

#include "engine/platform/folders.h"

namespace moltact {
std::filesystem::path settingsFile() {
  if (const auto config = folderFromEnvironment("XDG_CONFIG_HOME"); !config.empty())
    return config / "moltact" / "settings.json";
  if (const auto home = folderFromEnvironment("HOME"); !home.empty())
    return home / ".config" / "moltact" / "settings.json";
  return {};
}

std::filesystem::path ownLessonsFolder() {
  const std::filesystem::path data = userDataFolder();
  return data.empty() ? data : data / "lessons";
}

std::filesystem::path cacheFolder() {
  if (const auto cache = folderFromEnvironment("XDG_CACHE_HOME"); !cache.empty()) return cache / "moltact";
  if (const auto home = folderFromEnvironment("HOME"); !home.empty()) return home / ".cache" / "moltact";
  return {};
}

std::filesystem::path pictureFolder() {
  std::error_code error;
  const auto home = folderFromEnvironment("HOME");
  if (!home.empty() && std::filesystem::is_directory(home / "Pictures", error)) return home / "Pictures";
  return home.empty() ? std::filesystem::current_path(error) : home;
}

}  // namespace moltact
