// Where the window keeps what belongs to the person, after the XDG base directories.
#pragma once

#include <filesystem>

namespace moltact {

/// $XDG_CONFIG_HOME/moltact/settings.json, or under ~/.config; empty where there is no home.
std::filesystem::path settingsFile();
/// userDataFolder()/lessons: where a person's own lessons are looked for unless the settings say otherwise; may not
/// exist.
std::filesystem::path ownLessonsFolder();
/// $XDG_CACHE_HOME/moltact, or under ~/.cache: what can be made again; empty where there is no home.
std::filesystem::path cacheFolder();
/// ~/Pictures where there is one, else the home folder, else the current folder.
std::filesystem::path pictureFolder();

}  // namespace moltact
