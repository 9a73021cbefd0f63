// The library of molecules that ship with the program, and the search for a molecule's file by name. Not for the haptic
// thread.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/core/problem.h"
#include "engine/molecule/molecule.h"
#include "engine/molecule/reader.h"

namespace moltact {

/// One entry of molecules/catalogue.json.
struct CatalogueEntry {
  std::string id;         ///< the name that a user types: "1ubq"
  std::string file;       ///< name in the molecules folder
  std::string title;      ///< one line for a list
  std::string good_for;   ///< what it demonstrates well
  std::string source;     ///< origin of the coordinates
  std::string left_out;   ///< parts of the source that the file omits; may be empty
  std::string licence;    ///< SPDX identifier
  std::size_t atoms = 0;  ///< as read by default
};

/// Reads the entries of `folder`/catalogue.json in order. A Problem states what is missing or invalid.
Expected<std::vector<CatalogueEntry>> readCatalogue(const std::filesystem::path& folder);

/// The folders in which a name is searched.
struct MoleculeFolders {
  std::filesystem::path library;      ///< with catalogue.json
  std::filesystem::path fetched;      ///< entries downloaded from the PDB; may not exist
  std::filesystem::path beside = {};  ///< a lesson's folder, where "5adh" matches 5ADH.cif.gz; empty: none

  /// The standard folders of this computer (engine/platform/folders.h).
  static MoleculeFolders ofThisComputer();
};

/// Finds the file of a name: a path, an id of the catalogue, or the id of a fetched entry, in upper or lower case. For
/// an unknown name the Problem contains the most similar id.
Expected<std::filesystem::path> findMolecule(const std::string& name, const MoleculeFolders& folders);
Expected<MoleculeKey> findMoleculeKey(const NamedMolecule& named, const MoleculeFolders& folders);

/// Returns a name that denotes the same file from any working folder: the id if the file belongs to the library or to a
/// fetched entry, else its absolute path.
NamedMolecule lastingName(const MoleculeKey& key, const MoleculeFolders& folders);

/// Performs findMolecule and readMolecule with the folders of this computer, for a command or the window. Blocks.
Expected<Molecule> openMolecule(const std::string& name, const ReadOptions& options = {});

}  // namespace moltact
