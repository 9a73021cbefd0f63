// The covalent bonds of a molecule, and the bonds of metals to what holds them. Found when they are asked for, at a
// person's pace; pure functions, any thread but the haptic one. Units: angstrom.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "engine/molecule/molecule.h"

namespace moltact {

/// All bonds, ascending by their first atom, then their second, each once:
/// * those of a file that lists them (SDF, MOL), as it lists them;
/// * within the twenty amino acids and the eight nucleotides those of their formula, with their orders, so that a clash
///   in a poor structure makes none; between them the peptide bond, the phosphate's and disulphides;
/// * elsewhere two atoms nearer than the sum of their covalent radii (Cordero et al., Dalton Trans. 2832, 2008) and
///   0.45 A, their order unknown; a hydrogen has one, to its nearest; with a metal it is a Coordination, which carbon
///   and hydrogen have only within a residue.
std::vector<Bond> findBonds(const Molecule& molecule);

/// The atoms bonded to each: those of atom i are neighbours(i).
class BondTable {
 public:
  BondTable(std::size_t atoms, std::span<const Bond> bonds);
  std::span<const std::uint32_t> neighbours(std::size_t atom) const {
    return {list_.data() + begin_[atom], begin_[atom + 1] - begin_[atom]};
  }
  bool bonded(std::size_t a, std::size_t b) const;

 private:
  std::vector<std::uint32_t> begin_, list_;
};

/// A bond of a residue's formula, by the names of its atoms.
struct NamedBond {
  std::string_view first, second;
  BondOrder order = BondOrder::Single;
};
/// The bonds between the heavy atoms of an amino acid or a nucleotide; empty for a residue of another name.
std::span<const NamedBond> formulaBonds(std::string_view residue_name);
/// An atom's name in formulas: O1P is OP1, a prime is no star, CD of isoleucine is CD1.
std::string_view formulaName(std::string_view residue_name, std::string_view atom_name);

}  // namespace moltact
