// The molecules that lessons name: which file a name means, and each of them read once. Not for the haptic thread.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "engine/core/problem.h"
#include "engine/molecule/molecule.h"

namespace moltact {

/// The file that a lesson means by a molecule's name: one in the lesson's folder, else of the library, else one that
/// was fetched. A problem without a place where there is none.
Expected<std::filesystem::path> lessonMoleculeFile(const std::filesystem::path& lesson_file, const std::string& name);

/// Keeps what it has read while it lives; a file that has changed since is read again.
class LessonMolecules {
 public:
  /// The molecule as a scene shows it. A problem without a place where there is none, or its file is at fault.
  Expected<std::shared_ptr<const Molecule>> find(const std::filesystem::path& lesson_file, const std::string& name);

 private:
  struct Kept {
    std::filesystem::file_time_type written;
    Expected<std::shared_ptr<const Molecule>> molecule;
  };
  std::map<std::filesystem::path, Kept> kept_;
};

}  // namespace moltact
