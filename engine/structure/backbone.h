// The backbone of a molecule's chains, for ribbons and for the search of hydrogen bonds. Computed on request, not in a
// tick; pure functions, any thread except the haptic one. Atoms and residues are indices into the Molecule.
#pragma once

#include <cstdint>
#include <vector>

namespace moltact {

struct Molecule;

inline constexpr std::uint32_t kNoAtom = 0xFFFFFFFFu;

/// The backbone atoms of an amino acid: CA is always set; each of the others may be kNoAtom (a file may contain CA
/// alone).
struct AminoAcidAtoms {
  std::uint32_t residue = 0;
  std::uint32_t n = kNoAtom, ca = kNoAtom, c = kNoAtom, o = kNoAtom;
  bool whole() const { return n != kNoAtom && ca != kNoAtom && c != kNoAtom && o != kNoAtom; }
};

/// The guide atoms of a nucleotide: P or, at a 5' end without a phosphate, O5' is set; each of the others may be
/// kNoAtom.
struct NucleotideAtoms {
  std::uint32_t residue = 0;
  std::uint32_t p = kNoAtom;     ///< phosphorus; kNoAtom at a 5' end without phosphate
  std::uint32_t o5 = kNoAtom;    ///< O5'
  std::uint32_t c1 = kNoAtom;    ///< C1', to which the base is bonded
  std::uint32_t o3 = kNoAtom;    ///< O3', bonded to the phosphorus of the next nucleotide
  std::uint32_t base = kNoAtom;  ///< atom of the base nearest to its partner: N1 of a purine, N3 of a pyrimidine
  bool purine = false;
  std::uint32_t guide() const { return p != kNoAtom ? p : o5; }  ///< the atom that a ribbon passes through
};

/// Consecutive residues without a gap, from the N-terminus or the 5' end.
using ProteinStretch = std::vector<AminoAcidAtoms>;
using NucleicStretch = std::vector<NucleotideAtoms>;

/// Returns the stretches of all chains in file order. In proteins a gap is a distance between C and N of neighbours
/// above 2.5 A (Kabsch & Sander 1983). If one of them is missing, it is one between the CA above 5 A. In nucleic acids
/// it is a distance between O3' and P above 2.5 A or, if one is missing, between the guides above 9 A.
std::vector<ProteinStretch> proteinBackbone(const Molecule& molecule);
std::vector<NucleicStretch> nucleicBackbone(const Molecule& molecule);

}  // namespace moltact
