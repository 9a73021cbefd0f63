// The folders of the user's data, according to the XDG base directories.
#pragma once

#include <filesystem>
#include <string>

namespace moltact {

/// $XDG_CONFIG_HOME/moltact/settings.json, or under ~/.config; empty if there is no home folder.
std::filesystem::path settingsFile();
/// userDataFolder()/lessons: the default folder of the user's own lessons. It may not exist.
std::filesystem::path ownLessonsFolder();
/// $XDG_CACHE_HOME/moltact, or under ~/.cache: files that can be regenerated; empty if there is no home folder.
std::filesystem::path cacheFolder();
/// The desktop's picture folder (XDG_PICTURES_DIR in user-dirs.dirs, for example ~/Bilder on a German desktop), else
/// ~/Pictures; the first that exists. Otherwise the home folder, or without one the current folder.
std::filesystem::path pictureFolder();

/// A path as the user typed it; ~/ is replaced by the home folder.
std::filesystem::path typedPath(const std::string& typed);

}  // namespace moltact
