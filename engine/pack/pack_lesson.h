// Makes a pack (pack_file.h) of a lesson file and all that it needs from the author's computer. Any thread but the
// haptic one.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/problem.h"

namespace moltact {

struct Packed {
  std::string bytes;                 ///< the same for the same files: sorted names, one date, one level of compression
  std::vector<std::string> files;    ///< by name
  std::vector<std::string> library;  ///< molecules that are not packed, for every Moltact has them
};

struct PackedLesson {
  std::optional<Packed> pack;     ///< only where `errors` is empty
  std::vector<Problem> errors;    ///< of the check and of what cannot be packed, each at its place
  std::vector<Problem> warnings;  ///< of the check
};

/// Packed are: the lesson; it in other languages beside it; the lessons and other files that it leads to; its pictures;
/// its molecules, from the lesson's folder or downloaded from the PDB. Those of the library come with every Moltact and
/// are named only. Every lesson is checked first. What lies outside the
/// lesson's folder is refused, also where a link leads there.
PackedLesson packLesson(const std::filesystem::path& lesson_file);

}  // namespace moltact
