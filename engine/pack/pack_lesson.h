// Creates a pack (pack_file.h) from a lesson file and all files that it needs. Any thread except the haptic one; blocks
// on downloads.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/problem.h"

namespace moltact {

struct Packed {
  std::string bytes;                 ///< reproducible: sorted names, a fixed date, a fixed compression level
  std::vector<std::string> files;    ///< by name
  std::vector<std::string> library;  ///< molecules of the library, which are not packed because every Moltact has them
};

struct PackedLesson {
  std::optional<Packed> pack;     ///< set only if `errors` is empty
  std::vector<Problem> errors;    ///< of the check, and files that cannot be packed
  std::vector<Problem> warnings;  ///< of the check
};

/// Packs the lesson, its translations beside it, the lessons and other files to which it links, its pictures, and its
/// molecules, from the lesson's folder or downloaded from the PDB. Molecules of the library are named only. Every
/// lesson is checked first. Files outside the lesson's folder are rejected, also behind a link.
PackedLesson packLesson(const std::filesystem::path& lesson_file);

}  // namespace moltact
