// What is wrong with the parameters of a molecule's atoms, as a sentence for the window. `moltact info --charges` names
// the residues. Any thread except the haptic one.
#pragma once

#include <string>

#include "engine/structure/amber/pair_atoms.h"

namespace moltact {

/// In the language in use; empty if nothing is wrong. Reports atoms of unknown elements and a net charge far from a
/// whole number. Atoms in one place are no fault here: ligands that are held in turn may share a site. Unless the charges are the file's, it also reports residues without charges or with
/// charges of some atoms only.
std::string chargeFaults(const PairAtoms& assigned);

}  // namespace moltact
