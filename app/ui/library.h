// What comes with the program: its molecules and lessons, as menus list them. Read once. Window's thread.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace moltact {

struct LibraryItem {
  std::string id;     ///< "1ubq"
  std::string label;  ///< "Ubiquitin (1UBQ)"
  std::filesystem::path file;
};

/// The molecules of the catalogue; empty where the program's data are not found.
const std::vector<LibraryItem>& library();
/// The lesson files in the program's lessons folder, by name.
const std::vector<LibraryItem>& lessons();

}  // namespace moltact
