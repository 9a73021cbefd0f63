// The program's molecules and lessons as menus list them, read once per language; and folders of lessons. Window's
// thread.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace moltact {

struct LibraryItem {
  std::string id;     ///< "1ubq"; for a lesson its name without the language
  std::string label;  ///< "Ubiquitin (1UBQ)"
  std::filesystem::path file;
  std::string level = {};  ///< lessons only, in English: "beginner"
  int minutes = 0;         ///< lessons only; 0: not given
  int order = 0;           ///< lessons only: the position among the lessons that the author gives; 0: not given
};

/// The order of lessons in every list. Lessons with a position come first, in that order; the others follow by level
/// (beginners first), duration and name.
bool precedes(const LibraryItem& a, const LibraryItem& b);

/// The rank of a level (its English name) in a list; 0 is first.
int levelRank(std::string_view level);

/// The lesson for newcomers.
inline constexpr std::string_view kFirstLesson = "first-touch";

/// The molecules of the catalogue, with titles in the language in use. Empty if the program's data are not found.
const std::vector<LibraryItem>& library();
/// The lessons on this computer in the order of precedes(), each once, in the language in use. They come from
/// `lessons` in each of sharedDataFolders() and from the program's own folder.
const std::vector<LibraryItem>& lessons();
/// The lessons in a folder by name, each once, in the language in use. Empty if the folder cannot be read.
std::vector<LibraryItem> lessonItems(const std::filesystem::path& folder);
/// The lessons in several folders in the order of precedes(). Of lessons with the same name, the one in the first
/// folder counts, so that a school can replace a lesson by its own version.
std::vector<LibraryItem> lessonsOf(const std::vector<std::filesystem::path>& folders);
/// One lesson, with the properties that its front matter gives.
LibraryItem lessonItem(const std::filesystem::path& file);

}  // namespace moltact
