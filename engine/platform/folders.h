// The folders of the program and the user on this computer. Not for the haptic thread.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace moltact {

/// The folder that contains `molecules`, `lessons` and `assets`: $MOLTACT_HOME if set. Otherwise the first folder with
/// molecules/catalogue.json among the folder of the executable, share/moltact of its installation prefix, and the
/// source tree (not in a package).
std::filesystem::path homeFolder();

std::filesystem::path moleculesFolder();  ///< homeFolder()/molecules
std::filesystem::path lessonsFolder();    ///< homeFolder()/lessons
std::filesystem::path assetsFolder();     ///< homeFolder()/assets

/// The folder of the translation catalogues (de.mo etc.): homeFolder()/translations, else `translations` beside the
/// executable, else that of the build (not in a package).
std::filesystem::path translationsFolder();

/// Where a module of the program (a library that is loaded on demand) may be, the most likely place first: `modules`
/// beside the executable or in the build (not in a package), the folder of modules of the installation. `name` without
/// an extension. The files may not exist.
std::vector<std::filesystem::path> moduleFiles(const std::string& name);

/// Where another program of the project may be, the most likely place first: beside the executable, in the folder of
/// modules of the installation. `name` without an extension. The files may not exist.
std::vector<std::filesystem::path> programFiles(const std::string& name);

/// The browser edition, moltact.html: from homeFolder(), else from the build of the preset `web`. Empty if neither
/// exists.
std::filesystem::path browserEdition();

/// The folders of $XDG_DATA_DIRS in order. If it is not set: /usr/local/share and /usr/share; on Windows %ProgramData%.
std::vector<std::filesystem::path> systemDataFolders();

/// Folders for data that an administrator provides for all users: `moltact` in each of systemDataFolders(), the most
/// important first. The program's own folder is not included. They may not exist.
std::vector<std::filesystem::path> sharedDataFolders();

/// The folder of the running executable. Empty if the system does not provide it.
std::filesystem::path executablesFolder();

/// The folder named by an environment variable. Empty if it is not set or not absolute: the XDG base directory
/// specification requires that relative paths are ignored, and a relative home would depend on the working folder. On
/// Windows, HOME and the XDG variables default to the corresponding Windows folders.
std::filesystem::path folderFromEnvironment(const char* name);

/// The folder of the user's data, downloaded or created: $XDG_DATA_HOME/moltact, else ~/.local/share/moltact. It may
/// not exist yet. Empty if neither variable gives a home.
std::filesystem::path userDataFolder();

/// userDataFolder()/molecules: entries downloaded by `moltact fetch`.
std::filesystem::path userMoleculesFolder();

}  // namespace moltact
