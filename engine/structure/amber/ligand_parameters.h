// Parameters of atoms that no template covers. Lennard-Jones: the general AMBER force field (GAFF 1.4, Wang et al., J.
// Comput. Chem. 25, 1157, 2004), by element and hybridisation. Charges: partial equalisation of orbital electronegativity
// (Gasteiger & Marsili, Tetrahedron 36, 3219, 1980). Any thread except the haptic one. Units: angstrom, kcal/mol,
// elementary charge.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "engine/structure/amber/valences.h"

namespace moltact {

struct GaffType {
  std::string_view name;  ///< "c3"
  float half_minimum_A, depth_kcal_mol;
};

/// The type of an atom; nullptr for an element that GAFF does not have. `neighbours` are the atoms bonded to it; of a
/// hydrogen the first entry carries it, and `around` are those bonded to that carrier.
const GaffType* gaffType(const Molecule& molecule, std::span<const AtomValence> valences, std::uint32_t atom,
                         std::span<const std::uint32_t> neighbours, std::span<const std::uint32_t> around);

/// True if charges can be computed for the element: H, C, N, O, F, P, S, Cl, Se, Br, I.
bool hasElectronegativity(int atomic_number);

struct GasteigerCharges {
  std::vector<float> atoms_e;      ///< one per atom; 0 for those not wanted
  std::vector<float> hydrogens_e;  ///< of each of the atom's hydrogens that the file lacks (AtomValence::hydrogens)
};

/// Six iterations from the formal charges. Charge flows along bonds between wanted atoms of known electronegativity
/// only, so that the charge of a residue beside others is its formal charge, a whole number. The parameters are those
/// of the paper. Those of phosphorus, the nitrogen of amides and anilines and the sulphur of sulphones are of later
/// work with the method, and are Open Babel's. Selenium has those of sulphur.
GasteigerCharges gasteigerCharges(const Molecule& molecule, std::span<const Bond> bonds,
                                  const std::vector<char>& wanted, std::span<const AtomValence> valences);

}  // namespace moltact
