// The helices and strands of a molecule, from the records of its file or else from its hydrogen bonds. Computed on
// request, not in a tick (time grows with the number of residues); pure functions, any thread except the haptic one.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/molecule/molecule.h"

namespace moltact {

/// One helix or strand: consecutive residues by index into Molecule::residues, both ends included. A strand's arrow
/// points at `last_residue`.
struct StructureElement {
  SecondaryStructure kind = SecondaryStructure::Helix;
  HelixKind helix = HelixKind::Alpha;  ///< of a helix
  std::uint32_t first_residue = 0, last_residue = 0;
  friend bool operator==(const StructureElement&, const StructureElement&) = default;
};

struct MoleculeStructure {
  enum class Source : std::uint8_t { File, HydrogenBonds };
  Source source = Source::HydrogenBonds;
  std::vector<SecondaryStructure> of_residue;  ///< one per residue; Coil for residues other than amino acids
  std::vector<StructureElement> elements;      ///< ordered by residue
};

/// Uses the file's records if there are any, else hydrogen bonds.
MoleculeStructure secondaryStructure(const Molecule& molecule);

/// The method of W. Kabsch and C. Sander, Biopolymers 22, 2577 (1983). A backbone hydrogen bond has an energy below
/// -0.5 kcal/mol; each N-H keeps its best two. Helices are consecutive turns (alpha first, then 3-10 and pi where there
/// is no other); strands are ladders of at least two bridges, including bulges. Bends, single turns and single bridges
/// are Coil. Positions of hydrogens are computed as in the paper, whether or not the file contains them.
MoleculeStructure structureByHydrogenBonds(const Molecule& molecule);

}  // namespace moltact
