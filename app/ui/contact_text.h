// What the probe touches, in words: for the view, the status bar, those who cannot see it well, and the tests.
#pragma once

#include <string>

#include "engine/haptics/tracker.h"
#include "engine/molecule/molecule.h"

namespace moltact {

/// "touching: crease between N and CA of Ala 3 (chain A), 1.2 N"; "not touching"; or why there is no force.
/// Atoms out of the molecule's range are left out.
std::string contactText(const Molecule* molecule, const Contact& contact, double force_N);

/// The atoms in words, those of one residue together: "N and CA of Ala 3 (chain A) and O of Gly 4 (chain A)".
std::string atomsText(const Molecule& molecule, const std::array<std::int32_t, 3>& atoms);

}  // namespace moltact
