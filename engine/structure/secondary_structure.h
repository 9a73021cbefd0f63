// The helices and strands of a molecule: as its file records them, else from its hydrogen bonds. Worked out when it is
// asked for, at a person's pace (time grows with the number of residues); pure functions, any thread but the haptic
// one.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/molecule/molecule.h"

namespace moltact {

/// One helix or one strand: residues that follow one another, by index into Molecule::residues, both included. A
/// strand's arrow stands at `last_residue`.
struct StructureElement {
  SecondaryStructure kind = SecondaryStructure::Helix;
  HelixKind helix = HelixKind::Alpha;  ///< of a helix
  std::uint32_t first_residue = 0, last_residue = 0;
  friend bool operator==(const StructureElement&, const StructureElement&) = default;
};

struct MoleculeStructure {
  enum class Source : std::uint8_t { File, HydrogenBonds };
  Source source = Source::HydrogenBonds;
  std::vector<SecondaryStructure> of_residue;  ///< one for each of Molecule::residues; Coil for what is no amino acid
  std::vector<StructureElement> elements;      ///< in the order of the residues
};

/// From the file's records where it has any, else from hydrogen bonds.
MoleculeStructure secondaryStructure(const Molecule& molecule);

/// After W. Kabsch and C. Sander, Biopolymers 22, 2577 (1983): a backbone hydrogen bond is one of less than
/// -0.5 kcal/mol, of which each N-H has its best two; helices are turns that follow one another (alpha, then 3-10 and pi
/// where no other is), strands are ladders of two bridges or more, with their bulges. Bends, single turns and single
/// bridges are Coil. Hydrogens are placed as there, whether or not the file has them.
MoleculeStructure structureByHydrogenBonds(const Molecule& molecule);

}  // namespace moltact
