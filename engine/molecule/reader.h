// Reads a molecule from a file of one of the formats of moleculeEndings(), also gzipped. Not for the haptic thread.
// Units: angstrom. A file that cannot be read gives a Problem with the file, the line where it is known, and a remedy;
// nothing throws or hangs.
//
// Rules, the same for every format that names its atoms; a .xyzr file is spheres, each with a radius of its own, and is
// taken as it stands:
// * Atoms keep the order of the file; hydrogens are kept as present.
// * Alternate locations: of the atoms of one residue with the same name the one with the highest occupancy is kept,
//   the first on a tie. Where the alternatives are different residues (a point mutation), the residue with the
//   highest mean occupancy is kept whole. Alternates are looked for among at most 100 000 atoms and 100 residues at a
//   place.
// * Water (HOH, WAT, H2O, DOD, TIP3, SOL) is left out unless asked for or unless the file holds nothing else.
// * A radius is the file's own (PQR), else from elements.h; an unknown element gets the default and one warning.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/problem.h"
#include "engine/molecule/molecule.h"
#include "engine/molecule/molecule_key.h"

namespace moltact {

/// A file larger than this, or one that unpacks to more, is refused (unit: byte).
inline constexpr std::size_t kMaxMoleculeBytes = std::size_t{1} << 30;

/// A molecule of more atoms is refused, whether the file has them or an assembly makes them.
inline constexpr std::size_t kMaxMoleculeAtoms = 25'000'000;

/// The memory for an atom with its residue, its chain and the reader's own needs (unit: byte). One whose residues and
/// chains take more for so many atoms is refused: reading takes no more than 3 GB.
inline constexpr std::size_t kMoleculeBytesAnAtom = 120;

/// A coordinate or radius farther out than this is refused (unit: angstrom).
inline constexpr double kMaxCoordinate_A = 1e9;

/// The endings of the names that are read, in lower case and without .gz: ".pdb", ".cif" and so on.
std::vector<std::string_view> moleculeEndings();
/// The same for a sentence: ".cif .pdb .ent".
std::string moleculeEndingsText();

/// Whether a reader may know the file, by its name: one of these endings, with or without .gz, in whatever case.
bool hasMoleculeName(const std::filesystem::path& file);

/// The molecule in the file. The format follows from the name (moleculeEndings(), each also with .gz) and, where the name
/// does not tell, from the content.
Expected<Molecule> readMolecule(const std::filesystem::path& file, const ReadOptions& options = {});
inline Expected<Molecule> readMolecule(const MoleculeKey& key) { return readMolecule(key.file, key.reading); }

/// The same from bytes in memory, gzipped or not; `file` gives the name for the format and for problems.
Expected<Molecule> readMoleculeBytes(std::string bytes, const std::filesystem::path& file,
                                     const ReadOptions& options = {});

}  // namespace moltact
