// Assigns element, type and partial charge to each atom of a molecule, for interactions with forces beyond contact.
// Any thread but the haptic one. Unit: elementary charge.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "engine/haptics/atom_chemistry.h"
#include "engine/haptics/touch_setup.h"
#include "engine/molecule/molecule.h"

namespace moltact {

/// Formal charges in water at pH 7, one for each atom. Asp and Glu: -1/2 on each carboxylate oxygen. Lys: +1 on NZ. Arg:
/// +1/2 on NH1 and NH2. HIP: +1/2 on ND1 and NE2. CYM: -1 on SG. A phosphate of a nucleotide: -1/2 on each
/// non-bridging oxygen. Where the file lacks some of a group's atoms, the others carry the whole charge. Ends of chains,
/// ions and ligands are left at 0.
std::vector<float> formalCharges_e(const Molecule& molecule);

/// Charges from the source of that name (chargeSources()). Without charges: for "none", for "file" where the file has
/// none, and for an unknown name.
AtomChemistry atomChemistry(const Molecule& molecule, std::string_view source);

/// The chemistry that an interaction with this setup needs; null where its kind needs none.
std::shared_ptr<const AtomChemistry> chemistryFor(const TouchSetup& touch, const Molecule& molecule);

}  // namespace moltact
