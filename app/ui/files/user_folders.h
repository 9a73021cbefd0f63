// Where the window keeps what belongs to the person, after the XDG base directories.
#pragma once

#include <filesystem>
#include <string>

namespace moltact {

/// $XDG_CONFIG_HOME/moltact/settings.json, or under ~/.config; empty where there is no home.
std::filesystem::path settingsFile();
/// userDataFolder()/lessons: where a person's own lessons are looked for unless the settings say otherwise; may not
/// exist.
std::filesystem::path ownLessonsFolder();
/// $XDG_CACHE_HOME/moltact, or under ~/.cache: what can be made again; empty where there is no home.
std::filesystem::path cacheFolder();
/// Where the desktop keeps pictures (XDG_PICTURES_DIR of user-dirs.dirs: ~/Bilder on a German one), else ~/Pictures, the
/// first that is there; else the home folder, and only without one the current folder.
std::filesystem::path pictureFolder();

/// A path as a person typed it: ~/ is the home folder.
std::filesystem::path typedPath(const std::string& typed);

}  // namespace moltact
