// The library of molecules that come with the program, and how a name becomes a file. Not for the haptic
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
  std::string id;         ///< what a person types: "1ubq"
  std::string file;       ///< name in the molecules folder
  std::string title;      ///< one line for a list
  std::string good_for;   ///< what it shows well
  std::string source;     ///< where the coordinates come from
  std::string left_out;   ///< what the source has and the file has not; may be empty
  std::string licence;    ///< SPDX identifier
  std::size_t atoms = 0;  ///< as read by default
};

/// The entries of `folder`/catalogue.json, in its order; a Problem names what is missing or wrong.
Expected<std::vector<CatalogueEntry>> readCatalogue(const std::filesystem::path& folder);

/// The folders that a name is looked up in.
struct MoleculeFolders {
  std::filesystem::path library;      ///< with catalogue.json
  std::filesystem::path fetched;      ///< entries downloaded from the PDB; may not exist
  std::filesystem::path beside = {};  ///< a lesson's folder, where "5adh" may be 5ADH.cif.gz; empty: none

  /// Those of this computer (engine/platform/folders.h).
  static MoleculeFolders ofThisComputer();
};

/// The file that a person means: a path, an id of the catalogue, or the id of a fetched entry, in upper or
/// lower case. An unknown name gives a Problem with the nearest id.
Expected<std::filesystem::path> findMolecule(const std::string& name, const MoleculeFolders& folders);
Expected<MoleculeKey> findMoleculeKey(const NamedMolecule& named, const MoleculeFolders& folders);

/// A name that findMolecule finds the same file by from any working folder: the id of the library or of a fetched
/// entry where the file is theirs, else its whole path.
NamedMolecule lastingName(const MoleculeKey& key, const MoleculeFolders& folders);

/// findMolecule and readMolecule with the folders of this computer: what a command or the window calls.
Expected<Molecule> openMolecule(const std::string& name, const ReadOptions& options = {});

}  // namespace moltact
