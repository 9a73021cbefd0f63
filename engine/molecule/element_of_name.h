// Derives the element from an atom's name, for formats without elements (PQR and GRO). Internal to engine/molecule.
#pragma once

#include <string_view>

namespace moltact {

/// The atomic number; 0 if the name does not determine it. In amino acids, nucleotides and water the first letter
/// counts; in a residue named like its atom the whole name ("NA+" in "NA"). Elsewhere two letters count for Cl, Br, Fe,
/// Zn, Mg, Mn, Cu, Ni, Si and Se, and the first letter otherwise.
int elementOfName(std::string_view atom, std::string_view residue);

/// True for a massless point of a water model ("MW", "EPW").
bool isVirtualSite(std::string_view atom, std::string_view residue);

/// True for a nucleotide's name in simulation programs: DA, DA5, RU3, A, U5.
bool isNucleotideName(std::string_view residue);

}  // namespace moltact
