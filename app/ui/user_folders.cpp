#include "app/ui/user_folders.h"

#include <cstdlib>
#include <system_error>

#include "engine/platform/folders.h"

namespace moltact {
namespace {

std::filesystem::path fromEnvironment(const char* name) {
  const char* value = std::getenv(name);
  return value && *value == '/' ? std::filesystem::path(value) : std::filesystem::path();
}

}  // namespace

std::filesystem::path settingsFile() {
  if (const auto config = fromEnvironment("XDG_CONFIG_HOME"); !config.empty()) return config / "moltact" / "settings.json";
  if (const auto home = fromEnvironment("HOME"); !home.empty()) return home / ".config" / "moltact" / "settings.json";
  return {};
}

std::filesystem::path ownLessonsFolder() {
  const std::filesystem::path data = userDataFolder();
  return data.empty() ? data : data / "lessons";
}

std::filesystem::path cacheFolder() {
  if (const auto cache = fromEnvironment("XDG_CACHE_HOME"); !cache.empty()) return cache / "moltact";
  if (const auto home = fromEnvironment("HOME"); !home.empty()) return home / ".cache" / "moltact";
  return {};
}

std::filesystem::path pictureFolder() {
  std::error_code error;
  const auto home = fromEnvironment("HOME");
  if (!home.empty() && std::filesystem::is_directory(home / "Pictures", error)) return home / "Pictures";
  return home.empty() ? std::filesystem::current_path(error) : home;
}

}  // namespace moltact
