// What an option or argument takes, where that is more than a text: told by --help, and completed in a shell by it
// (app/commands/completion.cpp).
#pragma once

namespace moltact {

inline constexpr const char* kFileType = "FILE";
inline constexpr const char* kFolderType = "FOLDER";
inline constexpr const char* kFilesOrFoldersType = "FILE|FOLDER";
inline constexpr const char* kMoleculeType = "FILE|ID";  ///< ID: of a molecule of the library
inline constexpr const char* kLanguageType = "LANGUAGE";

}  // namespace moltact
