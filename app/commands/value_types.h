// The types of option and argument values other than plain text. --help shows them, and the shell completion uses them
// (app/commands/completion.cpp).
#pragma once

namespace moltact {

inline constexpr const char* kFileType = "FILE";
inline constexpr const char* kFolderType = "FOLDER";
inline constexpr const char* kFilesOrFoldersType = "FILE|FOLDER";
inline constexpr const char* kMoleculeType = "FILE|ID";  ///< ID: a molecule of the library
inline constexpr const char* kLanguageType = "LANGUAGE";

}  // namespace moltact
