// The parameters of AMBER's force fields for proteins and nucleic acids: ff14SB (Maier et al., J. Chem. Theory Comput. 11,
// 3696, 2015), OL15 for DNA and OL3 for RNA. Each residue has a template: names, types and charges of all its atoms.
// Generated data (make_templates.py), every thread. Units: angstrom, kcal/mol, elementary charge.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace moltact {

/// Lennard-Jones parameters of a type of atom.
struct AmberType {
  std::string_view name;  ///< "CT"
  float half_minimum_A;   ///< half of the distance of lowest energy of two such atoms
  float depth_kcal_mol;   ///< of that minimum
};

struct AmberAtom {
  std::string_view name;  ///< in the residue: "CA"
  std::string_view type;
  float charge_e;
  std::int8_t parent;  ///< of a hydrogen, the index of the atom that carries it; -1 for other atoms
};

/// The template of this name, or an empty span. Names are AMBER's: HID, HIE and HIP are histidine with a proton on ND1, NE2
/// or both; a first N or C denotes the start or end of a chain (NALA, CALA); CYX is a cysteine in a disulphide; DA, DA5,
/// DA3 and A, A5, A3 are nucleotides of DNA and RNA inside a chain, at its 5' and at its 3' end.
std::span<const AmberAtom> amberTemplate(std::string_view name);

/// All names of templates.
std::span<const std::string_view> amberTemplateNames();

/// The type of this name, or nullptr.
const AmberType* amberType(std::string_view name);

/// True if a hydrogen of a template is polar: carried by nitrogen, oxygen or sulphur. Models with merged hydrogens keep
/// these and add the charges of the others to the carbons that carry them.
bool polarHydrogen(std::span<const AmberAtom> residue, const AmberAtom& atom);

}  // namespace moltact
