// The element of an atom whose file gives only its name, as PQR and GRO do. Inside engine/molecule only.
#pragma once

#include <string_view>

namespace moltact {

/// The atomic number, 0 where the name tells none: in amino acids, nucleotides and water the first letter; in a residue
/// named as its atom the whole ("NA+" in "NA"); elsewhere Cl, Br, Fe, Zn, Mg, Mn, Cu, Ni, Si and Se by two letters, the
/// rest by the first.
int elementOfName(std::string_view atom, std::string_view residue);

/// A point without mass that a model of water carries beside its atoms ("MW", "EPW").
bool isVirtualSite(std::string_view atom, std::string_view residue);

/// A nucleotide as simulation programs name it: DA, DA5, RU3, A, U5.
bool isNucleotideName(std::string_view residue);

}  // namespace moltact
