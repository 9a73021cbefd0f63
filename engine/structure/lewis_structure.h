// One Lewis structure of a molecule: a whole order for each bond and a whole formal charge for each atom, as files for
// other programs need them (engine/molecule/write_sdf.h). Computed on request; any thread except the haptic one.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/molecule/molecule.h"

namespace moltact {

struct LewisStructure {
  std::vector<Bond> bonds;                    ///< of the whole molecule, as findBonds() orders them
  std::vector<std::int8_t> formal_charges_e;  ///< one for each atom
};

/// The orders of the atoms for which `wanted` is not 0; bonds with an end elsewhere keep the order of findBonds(), and all
/// other atoms the charge 0.
/// * Orders that the file states stay. Of amino acids and nucleotides they are those of the formula, of other residues
///   without stated orders those that lengths, angles and planar rings suggest (atomValences). An aromatic ring gets
///   alternating single and double bonds where every atom of it takes part, else it stays aromatic. What remains unknown
///   is single.
/// * Charges are the file's where it states any: in the atom's residue, or in a file that lists its bonds anywhere.
///   Otherwise a nitrogen with four stated bonds has the charge 1, other atoms with stated orders have none, and all
///   others have those of formalCharges_e() and atomValences(). Where several atoms share a charge, the oxygens with
///   single bonds take it, or the nitrogen with the double bond.
LewisStructure lewisStructure(const Molecule& molecule, const std::vector<char>& wanted);

}  // namespace moltact
