// Where the window keeps what belongs to the person, after the XDG base directories.
#pragma once

#include <filesystem>

namespace moltact {

/// $XDG_CONFIG_HOME/moltact/settings.json, or under ~/.config; empty where there is no home.
std::filesystem::path settingsFile();
/// ~/Pictures where there is one, else the home folder, else the current folder.
std::filesystem::path pictureFolder();

}  // namespace moltact
