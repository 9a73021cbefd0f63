// Finds the user's own lessons: in the user's lesson folder, in packs that were opened, and at other places from which
// a lesson was opened. Window's thread.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/ui/files/library.h"
#include "engine/core/problem.h"

namespace moltact {

/// The lessons of the packs in a folder (engine/pack/unpack.h), each once in the language in use. Of lessons with the
/// same name and title, the one that was unpacked last counts, because it is the newer version.
std::vector<LibraryItem> packedLessons(const std::filesystem::path& packs);

/// Returns those of the files that exist and are lessons by their front matter.
std::vector<LibraryItem> lessonsAmong(const std::vector<std::string>& files);

/// Copies a pack, or a lesson with all files that it needs, into the packs' folder. Returns the lesson's file, in the
/// language in use if there are several. On failure nothing is changed and a Problem is returned, for a lesson its
/// first error.
Expected<std::filesystem::path> addLesson(const std::filesystem::path& file, const std::filesystem::path& packs);

/// Looks in folders of lessons or packs for a file `name` in the folder of a lesson with this lesson's file name, or
/// below that folder. Empty if there is none.
std::filesystem::path fileBesideLesson(const std::string& lesson_file, const std::string& name,
                                       const std::vector<std::filesystem::path>& folders);

}  // namespace moltact
