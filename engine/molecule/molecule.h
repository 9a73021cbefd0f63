// A molecule: its topology (elements, names, residues, chains, bonds, charges) and, in a separate array, its
// coordinates. All arrays are immutable and shared: a molecule whose atoms have moved is a copy with another array of
// coordinates that shares everything else. Any thread may read it. Units: angstrom, elementary charge. Atoms are
// counted from 0 in file order, after exclusions.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/shared_array.h"
#include "engine/core/short_text.h"
#include "engine/core/sphere.h"
#include "engine/core/units.h"

namespace moltact {

inline constexpr std::uint32_t kNoResidue = 0xFFFFFFFFu;

/// The properties of an atom that do not change when it moves.
struct Atom {
  std::uint32_t residue = kNoResidue;  ///< index into Molecule::residues, or kNoResidue (.xyzr files have none)
  float b_factor_A2 = 0.0f;            ///< isotropic displacement factor of the file (unit: square angstrom); 0: none
  std::uint8_t atomic_number = 0;      ///< 1 = H, 6 = C, …; 0 = unknown
  std::array<char, 6> name{};          ///< name within the residue ("CA", "O5'"), zero-terminated

  std::string_view nameText() const { return name.data(); }
};

/// An atom with its coordinates.
struct PlacedAtom : Atom {
  PointA position;        ///< centre
  double radius_A = 0.0;  ///< van der Waals radius

  Sphere sphere() const { return {position.A, radius_A}; }
};

enum class ResidueKind : std::uint8_t { AminoAcid, Nucleotide, Water, Ligand, Ion, Other };

/// The secondary structure of a protein's residue.
enum class SecondaryStructure : std::uint8_t { Coil, Helix, Strand };
/// The type of a helix by the residue to which its hydrogen bonds lead: i + 4 (alpha), i + 3 (3-10), i + 5 (pi); Other
/// if the file names another.
enum class HelixKind : std::uint8_t { Alpha, ThreeTen, Pi, Other };

/// The secondary structure of a residue according to the file's records.
struct RecordedStructure {
  SecondaryStructure kind = SecondaryStructure::Coil;
  HelixKind helix = HelixKind::Alpha;
  bool begins = false;  ///< first residue of its helix or strand, which may follow directly on another
  friend bool operator==(const RecordedStructure&, const RecordedStructure&) = default;
};

/// One residue: a contiguous range of atoms.
struct Residue {
  ShortText name;           ///< "ASP", "HEM", "DA"
  int number = 0;           ///< residue number of the file
  char insertion = ' ';     ///< insertion code; a space: none
  std::uint32_t chain = 0;  ///< index into Molecule::chains
  std::uint32_t first_atom = 0, atom_count = 0;
  ResidueKind kind = ResidueKind::Other;
  RecordedStructure recorded{};  ///< meaningless if Molecule::has_recorded_structure is false
};

enum class BondOrder : std::uint8_t { Unknown, Single, Double, Triple, Aromatic, Coordination };

/// A bond between two atoms, by index; first < second.
struct Bond {
  std::uint32_t first = 0, second = 0;
  BondOrder order = BondOrder::Unknown;
  friend bool operator==(const Bond&, const Bond&) = default;
};

struct Chain {
  ShortText name;  ///< "A"
  std::uint32_t first_residue = 0, residue_count = 0;
};

/// The parts of an atom's description.
struct AtomWords {
  std::string atom;     ///< "CA"; for an ion, which is its own residue, element and number: "zinc 201"
  std::string residue;  ///< "Asp 52"; empty if the atom is its own residue or has none
  std::string chain;    ///< "A"; may be empty
};

struct Molecule {
  std::string id;     ///< short name for the screen: "1UBQ", "benzene"
  std::string title;  ///< description in one line; may be empty
  SharedArray<Atom> atoms;
  SharedArray<Sphere> spheres;          ///< the coordinates: centre and van der Waals radius of each atom, not inflated
  SharedArray<Sphere> spheres_as_read;  ///< the file's coordinates after movedTo(), else empty
  SharedArray<float> charges_e;         ///< partial charge of each atom from the file; empty: the file has none
  SharedArray<Residue> residues;
  SharedArray<Chain> chains;
  /// The bonds of a file that lists all of them (SDF, MOL), ascending. engine/structure/bonds.h finds the bonds of any
  /// molecule.
  SharedArray<Bond> listed_bonds;
  bool has_recorded_structure = false;    ///< the file records helices and strands
  SharedArray<std::string> warnings;      ///< what the reader omitted, replaced or guessed, one sentence each
  std::uint32_t waters_left_out = 0;      ///< water molecules of the file that are not among the atoms
  std::uint32_t alternates_left_out = 0;  ///< atoms at alternate locations that were not kept
  std::uint32_t models_in_file = 1;       ///< this is one of them
  /// The number of each atom among those of its model in the file, from 0, in ascending order; empty: atom i is atom i
  /// of the file. The frames of a trajectory have the file's atoms, water and alternates included.
  SharedArray<std::uint32_t> numbers_in_file;
  std::uint32_t atoms_in_file = 0;  ///< in its model; 0: unknown, as for an assembly
  double body_overlap_A = 0.5;      ///< RadiusTable::body_overlap_A of its radii
  std::uint32_t beside_from = 0;    ///< index of the first atom of a second molecule (side_by_side.h); 0: none
  std::string beside_id;            ///< short name of the second molecule

  /// An atom with its coordinates. `atom` must be in range.
  PlacedAtom at(std::size_t atom) const;
  /// Copies all atoms with their coordinates.
  std::vector<PlacedAtom> placedAtoms() const;
  /// Replaces the atoms and their coordinates.
  void setAtoms(const std::vector<PlacedAtom>& placed);
  /// Returns the molecule with other coordinates, one per atom.
  Molecule movedTo(SharedArray<Sphere> coordinates) const;
  /// The file's coordinates. Bonds and secondary structure are computed from these and do not change with a motion.
  const SharedArray<Sphere>& spheresAsRead() const { return spheres_as_read.empty() ? spheres : spheres_as_read; }
  /// True if both are the same molecule, possibly with different coordinates.
  bool sameTopology(const Molecule& other) const { return atoms.sharesWith(other.atoms); }

  /// The description on the screen and in the log: "O of Asp 52 (chain A)". `atom` must be in range.
  std::string describe(std::size_t atom) const;
  /// The parts of describe(). `atom` must be in range.
  AtomWords words(std::size_t atom) const;
};

}  // namespace moltact
