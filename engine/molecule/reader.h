// Reads a molecule from a file in one of the formats of moleculeEndings(), also gzipped. Blocks; not for the haptic
// thread. Units: angstrom. For an unreadable file the result is a Problem with the file, the line if known, and a
// remedy; nothing throws or hangs.
//
// Rules for all formats that name their atoms (an .xyzr file contains spheres with individual radii and is read
// unchanged):
// * Atoms keep the order of the file; hydrogens are kept if present.
// * Alternate locations: among atoms of the same name in one residue, the one with the highest occupancy is kept,
//   the first on a tie. Where the alternatives are different residues (a point mutation), the residue with the
//   highest mean occupancy is kept as a whole. The search is limited to 100 000 atoms and 100 residues per
//   residue number.
// * Water (HOH, WAT, H2O, DOD, TIP3, SOL) is omitted unless requested or unless the file contains nothing else.
// * The radius is that of the file (PQR), else that of elements.h; an unknown element gets the default and one warning.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/problem.h"
#include "engine/molecule/molecule.h"
#include "engine/molecule/molecule_key.h"

namespace moltact {

/// Limit on a file and on its unpacked size (unit: byte).
inline constexpr std::size_t kMaxMoleculeBytes = std::size_t{1} << 30;

/// Limit on the atoms of a molecule, read from the file or created by an assembly.
inline constexpr std::size_t kMaxMoleculeAtoms = 25'000'000;

/// The memory budget per atom, including its residue, its chain and the reader's own data (unit: byte). A molecule
/// whose residues and chains exceed the budget is rejected: reading takes at most 3 GB.
inline constexpr std::size_t kMoleculeBytesAnAtom = 120;

/// Limit on coordinates and radii (unit: angstrom).
inline constexpr double kMaxCoordinate_A = 1e9;

/// The file name endings of all formats, in lower case and without .gz: ".pdb", ".cif" etc.
std::vector<std::string_view> moleculeEndings();
/// The same as one text: ".cif .pdb .ent".
std::string moleculeEndingsText();
/// Those of formats with partial charges: ".mol2 .pqr .pdbqt".
std::string chargedEndingsText();

/// True if the file's name has one of these endings, with or without .gz, in upper or lower case.
bool hasMoleculeName(const std::filesystem::path& file);

/// Reads the molecule in the file. The format is determined by the name (moleculeEndings(), also with .gz), or by the
/// content if the name has no known ending.
Expected<Molecule> readMolecule(const std::filesystem::path& file, const ReadOptions& options = {});
inline Expected<Molecule> readMolecule(const MoleculeKey& key) { return readMolecule(key.file, key.reading); }

/// The same for bytes in memory, gzipped or not; `file` is the name for the format and for problems.
Expected<Molecule> readMoleculeBytes(std::string bytes, const std::filesystem::path& file,
                                     const ReadOptions& options = {});

}  // namespace moltact
