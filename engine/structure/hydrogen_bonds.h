// Hydrogen bonds between the heavy atoms of a molecule, for drawing and counting. Computed on request, not in a tick;
// pure functions, any thread except the haptic one. Units: angstrom.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/structure/bonds.h"

namespace moltact {

struct HydrogenBond {
  std::uint32_t donor = 0, acceptor = 0;  ///< heavy atoms, by index
  double length_A = 0.0;                  ///< distance between them
  friend bool operator==(const HydrogenBond&, const HydrogenBond&) = default;
};

/// Finds hydrogen bonds by heavy atoms alone, so that files with and without hydrogens give the same result. Criteria:
/// nitrogen and oxygen of two residues, at most 3.5 A apart, one a donor and one an acceptor. Every angle at either of
/// them, between the other and a bonded atom, is at least 90 degrees (E. N. Baker and R. E. Hubbard, Prog. Biophys.
/// Mol. Biol. 44, 97, 1984; I. K. McDonald and J. M. Thornton, J. Mol. Biol. 238, 777, 1994).
///
/// Donors and acceptors are determined by the formula in amino acids and nucleotides, otherwise by the bonds. Each pair
/// occurs once, with the first atom as donor if both can donate; ordered by donor, then acceptor. `bonds` must result
/// from findBonds().
std::vector<HydrogenBond> findHydrogenBonds(const Molecule& molecule, const BondTable& bonds);

}  // namespace moltact
