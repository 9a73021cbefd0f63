// The folders of this computer: the program's own data and the user's. Not for the haptic thread.
#pragma once

#include <filesystem>
#include <vector>

namespace moltact {

/// The folder that holds `molecules`, `lessons` and `assets`: $MOLTACT_HOME where set; else the folder of the
/// executable, share/moltact of the prefix that the executable is installed in, or that of the source tree (not in a
/// package), the first that has molecules/catalogue.json.
std::filesystem::path homeFolder();

std::filesystem::path moleculesFolder();  ///< homeFolder()/molecules
std::filesystem::path lessonsFolder();    ///< homeFolder()/lessons
std::filesystem::path assetsFolder();     ///< homeFolder()/assets

/// The folder that holds the catalogues of translations, de.mo and others: homeFolder()/translations, else
/// `translations` beside the executable, else that of the build (not in a package).
std::filesystem::path translationsFolder();

/// The browser edition, moltact.html: homeFolder()'s, else that of the preset `web` beside the program's own build. Empty
/// where it is in neither.
std::filesystem::path browserEdition();

/// The folders of $XDG_DATA_DIRS, in order, as they stand there; where that is not set, /usr/local/share and /usr/share,
/// on Windows %ProgramData%.
std::vector<std::filesystem::path> systemDataFolders();

/// Where an administrator puts what everyone on this computer is to have: `moltact` in each of systemDataFolders(), the
/// most important first. The program's own is not among
/// them; they may not exist.
std::vector<std::filesystem::path> sharedDataFolders();

/// The folder that the program itself lies in. Empty where the system does not say.
std::filesystem::path executablesFolder();

/// The folder that an environment variable names. Empty where it is not set or names none from the root: the XDG base
/// directory specification says that a relative path is to be ignored, and a relative home would be another one in
/// every folder. On Windows HOME and the variables of that specification are, where they are not set, those of Windows.
std::filesystem::path folderFromEnvironment(const char* name);

/// Where the program keeps what the user fetched or made: $XDG_DATA_HOME/moltact, else
/// ~/.local/share/moltact. It may not exist yet. Empty where neither variable gives a home.
std::filesystem::path userDataFolder();

/// userDataFolder()/molecules: the entries that `moltact fetch` downloaded.
std::filesystem::path userMoleculesFolder();

}  // namespace moltact
