// Assigns element, type and partial charge to each atom of a molecule, for interactions that set `needs_chemistry`.
// The layer `forces` has parameters of its own (PairField). Any thread except the haptic one. Unit: elementary charge.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "engine/haptics/atom_chemistry.h"
#include "engine/haptics/touch_setup.h"
#include "engine/molecule/molecule.h"

namespace moltact {

/// Formal charges in water at pH 7, one per atom. Asp and Glu: -1/2 on each carboxylate oxygen. Lys: +1 on NZ. Arg:
/// +1/2 on NH1 and NH2. HIP: +1/2 on ND1 and NE2. CYM: -1 on SG. Phosphate of a nucleotide: -1/2 on each non-bridging
/// oxygen. If the file lacks some of a group's atoms, the others carry the whole charge. Ends of chains, ions and
/// ligands have charge 0.
std::vector<float> formalCharges_e(const Molecule& molecule);

/// The chemistry with charges from the named source (chargeSources()). It has no charges for "none", for "file" if the
/// file has none, and for an unknown name.
AtomChemistry atomChemistry(const Molecule& molecule, std::string_view source);

/// The chemistry required by an interaction with this setup (needsChemistry()); null if it needs none.
std::shared_ptr<const AtomChemistry> chemistryFor(const TouchSetup& touch, const Molecule& molecule);

}  // namespace moltact
