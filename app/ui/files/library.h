// The molecules and lessons that come with the program, as menus list them, read once in each language; and lesson
// folders. Window's thread.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace moltact {

struct LibraryItem {
  std::string id;     ///< "1ubq"; of a lesson its name without the language
  std::string label;  ///< "Ubiquitin (1UBQ)"
  std::filesystem::path file;
  std::string level = {};  ///< of a lesson, in English: "beginner"
  int minutes = 0;         ///< of a lesson; 0: it says none
  int order = 0;           ///< of a lesson: its place among the others; 0: it says none
};

/// How two lessons stand to each other wherever lessons are listed: those to which their authors gave a place, in that
/// order, then by level, the newcomer's first, by length and name.
bool standsBefore(const LibraryItem& a, const LibraryItem& b);

/// Where a level's lessons stand in a list: 0 first. The level in English.
int levelRank(std::string_view level);

/// The lesson that a newcomer begins with.
inline constexpr std::string_view kFirstLesson = "first-touch";

/// The molecules of the catalogue, their titles in the language in use; empty where the program's data are not found.
const std::vector<LibraryItem>& library();
/// The lessons of this computer in the order of standsBefore(): those in `lessons` of sharedDataFolders(), and the program's; each once, in the
/// language in use.
const std::vector<LibraryItem>& lessons();
/// The lessons in a folder, by name; each once, in the language in use. Empty where it cannot be read.
std::vector<LibraryItem> lessonItems(const std::filesystem::path& folder);
/// The lessons in several folders in the order of standsBefore(). Of lessons with the same name that in the first folder counts: a newer
/// version, or one for this school.
std::vector<LibraryItem> lessonsOf(const std::vector<std::filesystem::path>& folders);
/// One lesson, with what its front matter says at a glance.
LibraryItem lessonItem(const std::filesystem::path& file);

}  // namespace moltact
