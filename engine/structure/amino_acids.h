// Properties of the twenty amino acids. Plain data; any thread.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace moltact {

/// The class of the side chain.
enum class SideChain : std::uint8_t { Hydrophobic, Polar, Charged };

struct AminoAcid {
  std::string_view code;  ///< "ASP"
  const char* name;       ///< "aspartic acid", in English
  SideChain side_chain;
  /// Charge of the side chain in water at pH 7 (unit: elementary charge): Asp and Glu -1, Lys and Arg +1. Histidine,
  /// with a pKa near 6, counts as neutral.
  int charge_e;
  /// Hydropathy (J. Kyte and R. F. Doolittle, J. Mol. Biol. 157, 105, 1982), from -4.5 (arginine) to 4.5 (isoleucine).
  double hydropathy;
};

/// All amino acids, ordered by code.
std::span<const AminoAcid> aminoAcids();

/// Finds the amino acid of a residue name. Names of simulation programs for a charge state, and modified residues, give
/// the parent amino acid: HIE gives HIS, MSE gives MET. The charge is that of the name (ASH: 0). Null for other
/// residues.
const AminoAcid* aminoAcid(std::string_view residue_name);
/// The charge at pH 7 according to the residue's name (unit: elementary charge): ASP -1, ASH 0, HIP +1.
int residueCharge_e(std::string_view residue_name);

}  // namespace moltact
