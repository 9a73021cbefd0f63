// What the codes of residues stand for, in plain words: "benzene" for BNZ, "thymine" for DT. Any thread.
#pragma once

#include <string>
#include <string_view>

namespace moltact {

/// The name in the language in use, as it stands within a sentence; empty for a code that is not in the table. Amino
/// acids are not: their codes (Ala, Lys) are what people say.
std::string plainResidueName(std::string_view code);

}  // namespace moltact
