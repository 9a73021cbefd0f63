// Finds the molecules that lessons name and reads each of them once. Not for the haptic thread.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <unordered_map>

#include "engine/core/problem.h"
#include "engine/molecule/molecule.h"
#include "engine/molecule/molecule_key.h"

namespace moltact {

/// The molecule that a name in a lesson refers to. The file is searched in the lesson's folder, then in the library.
/// Finally a file in the lesson's folder or a fetched one matches if the name lacks only its extension ("5adh":
/// 5ADH.cif.gz). A Problem without a place if there is none.
Expected<MoleculeKey> lessonMolecule(const std::filesystem::path& lesson_file, const NamedMolecule& named);

/// The file of a scene's `simulation`: beside the lesson, else beside the molecule's file. A Problem without a place if
/// there is none.
Expected<std::filesystem::path> simulationFile(const std::filesystem::path& lesson_file, const MoleculeKey& molecule,
                                               const std::string& name);

/// Caches the molecules, separately for each way of reading a file. A file that has changed is read again.
class LessonMolecules {
 public:
  /// The molecule of a scene. A Problem without a place if there is none or its file is faulty.
  Expected<std::shared_ptr<const Molecule>> find(const std::filesystem::path& lesson_file, const NamedMolecule& named);

 private:
  struct Kept {
    std::filesystem::file_time_type written;
    Expected<std::shared_ptr<const Molecule>> molecule;
  };
  std::unordered_map<MoleculeKey, Kept> kept_;
};

}  // namespace moltact
