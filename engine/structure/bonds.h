// The covalent bonds of a molecule and the coordination bonds of its metals. Computed on request, not in a tick; pure
// functions, any thread except the haptic one. Units: angstrom.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "engine/molecule/molecule.h"

namespace moltact {

/// Returns all bonds once each, ordered by first, then second atom:
/// * a file that lists its bonds (SDF, MOL): exactly these;
/// * within the twenty amino acids and the eight nucleotides: the bonds of the formula with their orders, so that a
/// clash in a poor structure creates none. Between residues: the peptide bond, the phosphodiester bond and disulphides;
/// * otherwise: two atoms nearer than the sum of their covalent radii (Cordero et al., Dalton Trans. 2832, 2008) plus
///   0.45 A, of unknown order. A hydrogen has one bond, to the nearest atom of its residue. A bond
///   between a metal and another atom than hydrogen is a Coordination. Carbon and other metals bond to a metal of their
///   own residue only. No bond joins two ligands of which atoms lie within 0.9 A of each other: they are alternatives in
///   one place.
std::vector<Bond> findBonds(const Molecule& molecule);

/// The bonded neighbours of each atom.
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

/// A bond of a residue's formula, by atom names.
struct NamedBond {
  std::string_view first, second;
  BondOrder order = BondOrder::Single;
};
/// The bonds between the heavy atoms of an amino acid or a nucleotide; empty for other residues.
std::span<const NamedBond> formulaBonds(std::string_view residue_name);
/// The atom's name as used in formulas: O1P becomes OP1, a star becomes a prime, CD of isoleucine becomes CD1.
std::string_view formulaName(std::string_view residue_name, std::string_view atom_name);

}  // namespace moltact
