// Where a person's own lessons are: in a folder of theirs, in packs that were opened, and wherever else one was opened
// from. Window's thread.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/ui/files/library.h"
#include "engine/core/problem.h"

namespace moltact {

/// The lessons of the packs in a folder (engine/pack/unpack.h), each once in the language in use; of lessons with the
/// same name and title the one that was unpacked last, for it is a newer version.
std::vector<LibraryItem> packedLessons(const std::filesystem::path& packs);

/// Those of these files that are lessons and there, by their front matter.
std::vector<LibraryItem> lessonsAmong(const std::vector<std::string>& files);

/// Puts a pack, or a lesson with all that it needs, into the packs' folder. Gives the lesson's file, of several
/// languages the one in use; a Problem (of a lesson its first error) where that cannot be, and then nothing is changed.
Expected<std::filesystem::path> addLesson(const std::filesystem::path& file, const std::filesystem::path& packs);

/// A file of this name in a folder of lessons or packs that holds a lesson of this file's name, or below it. Empty
/// where there is none.
std::filesystem::path fileBesideLesson(const std::string& lesson_file, const std::string& name,
                                       const std::vector<std::filesystem::path>& folders);

}  // namespace moltact
