#include "app/ui/files/user_folders.h"

#include <algorithm>
#include <string_view>
#include <system_error>

#include "engine/platform/folders.h"
#include "engine/platform/read_file.h"

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

namespace {

// Reads XDG_PICTURES_DIR="$HOME/Bilder" as xdg-user-dirs writes it; empty if there is no such line.
std::filesystem::path desktopsPictures(const std::filesystem::path& home) {
  constexpr std::size_t kMax_bytes = 1 << 16;
  constexpr std::string_view kKey = "XDG_PICTURES_DIR=\"", kHome = "$HOME";
  const auto config = folderFromEnvironment("XDG_CONFIG_HOME");
  const auto text = readFile((config.empty() ? home / ".config" : config) / "user-dirs.dirs", kMax_bytes, {});
  if (!text) return {};
  for (std::size_t at = 0; at < text->size();) {
    const std::size_t end = std::min(text->find('\n', at), text->size());
    std::string_view line = std::string_view(*text).substr(at, end - at);
    at = end + 1;
    if (!line.starts_with(kKey) || line.rfind('"') < kKey.size()) continue;
    line = line.substr(kKey.size(), line.rfind('"') - kKey.size());
    if (!line.starts_with(kHome)) return line;
    line.remove_prefix(kHome.size());
    while (line.starts_with('/')) line.remove_prefix(1);
    return home / line;
  }
  return {};
}

}  // namespace

std::filesystem::path pictureFolder() {
  std::error_code error;
  const auto home = folderFromEnvironment("HOME");
  if (const auto pictures = desktopsPictures(home);
      pictures.is_absolute() && std::filesystem::is_directory(pictures, error))
    return pictures;
  if (!home.empty() && std::filesystem::is_directory(home / "Pictures", error)) return home / "Pictures";
  return home.empty() ? std::filesystem::current_path(error) : home;
}

std::filesystem::path typedPath(const std::string& typed) {
  const auto home = folderFromEnvironment("HOME");
  return typed.starts_with("~/") && !home.empty() ? home / typed.substr(2) : std::filesystem::path(typed);
}

}  // namespace moltact
