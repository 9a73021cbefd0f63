// A molecule: its topology (elements, names, residues, chains, bonds, charges) and, in one array beside it, its
// coordinates. All arrays are immutable and shared: a molecule whose atoms have moved is a copy with another array of
// coordinates, and nothing else is copied. Any thread may read it. Units: angstrom, elementary charge. Atoms are counted
// from 0 in file order as kept.
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

/// What does not change when an atom moves.
struct Atom {
  std::uint32_t residue = kNoResidue;  ///< index into Molecule::residues, or kNoResidue (an .xyzr file has none)
  float b_factor_A2 = 0.0f;            ///< isotropic displacement as the file has it (unit: square angstrom); 0: none
  std::uint8_t atomic_number = 0;      ///< 1 = H, 6 = C, …; 0 = not known
  std::array<char, 6> name{};          ///< the atom's name in its residue ("CA", "O5'"), zero-terminated

  std::string_view nameText() const { return name.data(); }
};

/// An atom with its coordinates.
struct PlacedAtom : Atom {
  PointA position;        ///< centre
  double radius_A = 0.0;  ///< van der Waals radius

  Sphere sphere() const { return {position.A, radius_A}; }
};

enum class ResidueKind : std::uint8_t { AminoAcid, Nucleotide, Water, Ligand, Ion, Other };

/// The secondary structure that a residue of a protein takes part in.
enum class SecondaryStructure : std::uint8_t { Coil, Helix, Strand };
/// By which residue a turn's hydrogen bond goes on: the fourth, the third, the fifth; Other as a file may name it.
enum class HelixKind : std::uint8_t { Alpha, ThreeTen, Pi, Other };

/// What the depositors' records say of a residue.
struct RecordedStructure {
  SecondaryStructure kind = SecondaryStructure::Coil;
  HelixKind helix = HelixKind::Alpha;
  bool begins = false;  ///< the first residue of its helix or strand, which may follow upon another
  friend bool operator==(const RecordedStructure&, const RecordedStructure&) = default;
};

/// One residue: a run of atoms that belong together.
struct Residue {
  ShortText name;           ///< "ASP", "HEM", "DA"
  int number = 0;           ///< as in the file
  char insertion = ' ';     ///< insertion code, a space where there is none
  std::uint32_t chain = 0;  ///< index into Molecule::chains
  std::uint32_t first_atom = 0, atom_count = 0;
  ResidueKind kind = ResidueKind::Other;
  RecordedStructure recorded{};  ///< of no meaning where Molecule::has_recorded_structure is false
};

enum class BondOrder : std::uint8_t { Unknown, Single, Double, Triple, Aromatic, Coordination };

/// Two atoms that are bonded, by index; first < second.
struct Bond {
  std::uint32_t first = 0, second = 0;
  BondOrder order = BondOrder::Unknown;
  friend bool operator==(const Bond&, const Bond&) = default;
};

struct Chain {
  ShortText name;  ///< "A"
  std::uint32_t first_residue = 0, residue_count = 0;
};

/// The parts of an atom's name.
struct AtomWords {
  std::string atom;     ///< "CA"; of a residue of its own, as an ion is, its element and number: "zinc 201"
  std::string residue;  ///< "Asp 52"; empty where the atom is alone, or belongs to none
  std::string chain;    ///< "A"; may be empty
};

struct Molecule {
  std::string id;     ///< short name for the screen: "1UBQ", "benzene"
  std::string title;  ///< one line on what it is; may be empty
  SharedArray<Atom> atoms;
  SharedArray<Sphere> spheres;          ///< the coordinates: centre and van der Waals radius of each atom, not inflated
  SharedArray<Sphere> spheres_as_read;  ///< the coordinates of the file where movedTo() has replaced them, else empty
  SharedArray<float> charges_e;         ///< partial charge of each atom as the file has it; empty: the file has none
  SharedArray<Residue> residues;
  SharedArray<Chain> chains;
  SharedArray<Bond> listed_bonds;  ///< of a file that lists them all (SDF, MOL), ascending; engine/structure/bonds.h
                                   ///< finds those of every molecule
  bool has_recorded_structure = false;    ///< the file says which residues are helices and strands
  SharedArray<std::string> warnings;      ///< what the reader left out, replaced or guessed, one sentence each
  std::uint32_t waters_left_out = 0;      ///< water molecules in the file that are not among the atoms
  std::uint32_t alternates_left_out = 0;  ///< atoms at another alternate location than the one kept
  std::uint32_t models_in_file = 1;       ///< of which this is one
  std::uint32_t beside_from =
      0;                  ///< atoms from this one on are those of a second molecule (side_by_side.h); 0: of none
  std::string beside_id;  ///< that one's short name

  /// An atom with its coordinates. `atom` must be in range.
  PlacedAtom at(std::size_t atom) const;
  /// All atoms with their coordinates, copied.
  std::vector<PlacedAtom> placedAtoms() const;
  /// Replaces the atoms and their coordinates.
  void setAtoms(const std::vector<PlacedAtom>& placed);
  /// The same molecule with other coordinates, one for each atom.
  Molecule movedTo(SharedArray<Sphere> coordinates) const;
  /// The coordinates of the file. Bonds and secondary structure are found among these, and no motion changes them.
  const SharedArray<Sphere>& spheresAsRead() const { return spheres_as_read.empty() ? spheres : spheres_as_read; }
  /// Whether both are the same molecule, perhaps at other coordinates.
  bool sameTopology(const Molecule& other) const { return atoms.sharesWith(other.atoms); }

  /// "O of Asp 52 (chain A)", as the screen and the log say it. `atom` must be in range.
  std::string describe(std::size_t atom) const;
  /// The words that describe() is made of. `atom` must be in range.
  AtomWords words(std::size_t atom) const;
};

}  // namespace moltact
