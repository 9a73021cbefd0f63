// Classes of ligands, parts of polymers, and metals, by name or number. Pure functions; any thread except the haptic
// one.
#pragma once

#include <cstdint>
#include <string_view>

namespace moltact {

struct Molecule;

enum class LigandClass : std::uint8_t { Other, Heme, Sugar, Buffer };

/// Classifies a residue name: haems and related groups; common sugars; crystallization buffers, according to gemmi's
/// table of residues.
LigandClass ligandClass(std::string_view residue_name);

enum class PolymerPart : std::uint8_t { None, Backbone, SideChain };

/// Classifies an atom. Backbone: N, CA, C, O, OXT of an amino acid, phosphate and sugar of a nucleotide, and their
/// hydrogens. SideChain: their other atoms. None: atoms of other residues.
PolymerPart polymerPart(const Molecule& molecule, std::uint32_t atom);

bool isMetal(int atomic_number);

}  // namespace moltact
