// Which class a ligand is of, which part of a polymer an atom is, which elements are metals. Plain facts by name; any
// thread but the haptic one.
#pragma once

#include <cstdint>
#include <string_view>

namespace moltact {

struct Molecule;

enum class LigandClass : std::uint8_t { Other, Heme, Sugar, Buffer };

/// By the name of the residue: haems and their kin; common sugars; what crystals are grown in, as gemmi's table of
/// residues has it.
LigandClass ligandClass(std::string_view residue_name);

enum class PolymerPart : std::uint8_t { None, Backbone, SideChain };

/// Of an amino acid N, CA, C, O, OXT and their hydrogens are backbone; of a nucleotide phosphate and sugar with their
/// hydrogens; the rest is side chain. None for an atom of another residue.
PolymerPart polymerPart(const Molecule& molecule, std::uint32_t atom);

bool isMetal(int atomic_number);

}  // namespace moltact
