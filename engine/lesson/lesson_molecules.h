// The molecules that lessons name: which file a name means, and each of them read once. Not for the haptic thread.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <unordered_map>

#include "engine/core/problem.h"
#include "engine/molecule/molecule.h"
#include "engine/molecule/molecule_key.h"

namespace moltact {

/// The molecule that a lesson means by a name: its file is one in the lesson's folder, else of the library, else one in
/// the lesson's folder or one that was fetched, whose name goes on with an ending ("5adh": 5ADH.cif.gz). A problem
/// without a place where there is none.
Expected<MoleculeKey> lessonMolecule(const std::filesystem::path& lesson_file, const NamedMolecule& named);

/// Keeps what it has read while it lives, each reading of a file by itself; a file that has changed since is read
/// again.
class LessonMolecules {
 public:
  /// The molecule as a scene shows it. A problem without a place where there is none, or its file is at fault.
  Expected<std::shared_ptr<const Molecule>> find(const std::filesystem::path& lesson_file, const NamedMolecule& named);

 private:
  struct Kept {
    std::filesystem::file_time_type written;
    Expected<std::shared_ptr<const Molecule>> molecule;
  };
  std::unordered_map<MoleculeKey, Kept> kept_;
};

}  // namespace moltact
