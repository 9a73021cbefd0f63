// What is known of the twenty amino acids by name. Plain data; any thread.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace moltact {

/// Each of the twenty is in one of them.
enum class SideChain : std::uint8_t { Hydrophobic, Polar, Charged };

struct AminoAcid {
  std::string_view code;  ///< "ASP"
  const char* name;       ///< "aspartic acid", in English
  SideChain side_chain;
  /// Of the side chain in water at pH 7, in elementary charges: Asp and Glu -1, Lys and Arg +1. Histidine, with a pKa
  /// near 6, counts as neutral.
  int charge_e;
  /// J. Kyte and R. F. Doolittle, J. Mol. Biol. 157, 105 (1982): from -4.5 (arginine) to 4.5 (isoleucine).
  double hydropathy;
};

/// In the order of their codes.
std::span<const AminoAcid> aminoAcids();

/// The amino acid of a residue's name. Names that simulation programs give to a state of charge, and modified residues,
/// stand for the one that they are made from: HIE for HIS, MSE for MET; the charge is that of the name (ASH: 0). Null
/// for what is none of the twenty.
const AminoAcid* aminoAcid(std::string_view residue_name);
/// The charge at pH 7 that a residue's name tells (unit: elementary charge): ASP -1, ASH 0, HIP +1.
int residueCharge_e(std::string_view residue_name);

}  // namespace moltact
