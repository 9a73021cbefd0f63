// Hydrogen bonds between the heavy atoms of a molecule, as they are drawn and counted. Found when they are asked for, at
// a person's pace; pure functions, any thread but the haptic one. Units: angstrom.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/structure/bonds.h"

namespace moltact {

struct HydrogenBond {
  std::uint32_t donor = 0, acceptor = 0;  ///< the heavy atoms, by index
  double length_A = 0.0;                  ///< from one to the other
  friend bool operator==(const HydrogenBond&, const HydrogenBond&) = default;
};

/// By the heavy atoms alone, so that a file without hydrogens gives the same: nitrogen and oxygen of two residues not
/// farther apart than 3.5 A, one of which gives and one of which takes a hydrogen, with every angle at either between
/// the other and what it is bonded to of 90 degrees or more (E. N. Baker and R. E. Hubbard, Prog. Biophys. Mol. Biol.
/// 44, 97, 1984; I. K. McDonald and J. M. Thornton, J. Mol. Biol. 238, 777, 1994). Which atoms give and take follows in
/// amino acids and nucleotides from their formulas, elsewhere from their bonds. Each pair once, the first atom the donor
/// where both may give; ascending by donor, then acceptor. `bonds` are those of findBonds().
std::vector<HydrogenBond> findHydrogenBonds(const Molecule& molecule, const BondTable& bonds);

}  // namespace moltact
