// The backbone of a molecule's chains, as a ribbon follows it and a hydrogen bond is looked for along it. Made at a
// person's pace, when it is asked for; pure functions, any thread but the haptic one. Atoms and residues are indices
// into the Molecule.
#pragma once

#include <cstdint>
#include <vector>

namespace moltact {

struct Molecule;

inline constexpr std::uint32_t kNoAtom = 0xFFFFFFFFu;

/// A residue of a protein: CA is there, of the others each may be kNoAtom (a file of CA alone has no other).
struct AminoAcidAtoms {
  std::uint32_t residue = 0;
  std::uint32_t n = kNoAtom, ca = kNoAtom, c = kNoAtom, o = kNoAtom;
  bool whole() const { return n != kNoAtom && ca != kNoAtom && c != kNoAtom && o != kNoAtom; }
};

/// A nucleotide: P or, at a 5' end without a phosphate, O5' is there; of the others each may be kNoAtom.
struct NucleotideAtoms {
  std::uint32_t residue = 0;
  std::uint32_t p = kNoAtom;     ///< the phosphorus; kNoAtom at an end without one
  std::uint32_t o5 = kNoAtom;    ///< O5'
  std::uint32_t c1 = kNoAtom;    ///< C1', from which the base goes out
  std::uint32_t o3 = kNoAtom;    ///< O3', which the next nucleotide's phosphorus is bonded to
  std::uint32_t base = kNoAtom;  ///< the base's end toward its partner: N1 of a purine, N3 of a pyrimidine
  bool purine = false;
  std::uint32_t guide() const { return p != kNoAtom ? p : o5; }  ///< what a ribbon runs through
};

/// Residues that follow one another without a gap, from the N-terminus or the 5' end on.
using ProteinStretch = std::vector<AminoAcidAtoms>;
using NucleicStretch = std::vector<NucleotideAtoms>;

/// The stretches of every chain, in the order of the file. A gap is where C and N of neighbours lie farther apart than
/// 2.5 A (Kabsch & Sander 1983) or, where one of them is missing, the CA farther than 5 A; in nucleic acids O3' and P
/// farther than 2.5 A or, where one is missing, the guides farther than 9 A.
std::vector<ProteinStretch> proteinBackbone(const Molecule& molecule);
std::vector<NucleicStretch> nucleicBackbone(const Molecule& molecule);

}  // namespace moltact
