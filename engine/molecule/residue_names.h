// Plain names for residue codes: "benzene" for BNZ, "thymine" for DT. Any thread except the haptic one.
#pragma once

#include <string>
#include <string_view>

namespace moltact {

/// The translated name, as used within a sentence; empty for an unknown code. Amino acids are not included, because
/// their codes (Ala, Lys) are in common use.
std::string plainResidueName(std::string_view code);

}  // namespace moltact
