// The cartoon of a molecule: a ribbon along each chain's backbone, wide in helices, an arrow for each strand, a tube
// elsewhere. A nucleic acid is a band with a rung toward the partner of each base. Pure functions; any thread except
// the haptic one. Units: angstrom.
#pragma once

#include <cstdint>
#include <span>

#include "engine/molecule/molecule.h"
#include "engine/render/mesh_piece.h"
#include "engine/structure/secondary_structure.h"

namespace moltact {

/// Half widths and half thickness of the ribbon, by secondary structure.
inline constexpr double kHelixWidth_A = 1.35, kStrandWidth_A = 1.1, kArrowWidth_A = 1.9, kFlat_A = 0.28, kTube_A = 0.32;

/// Creates the mesh. `structure` is the molecule's secondary structure. `drawn[a]` is nonzero for atoms in the picture:
/// a residue is drawn if its CA (or the nucleotide's phosphorus) is, in the colour (packColour) of that atom. The
/// ribbon is closed at ends of chains, gaps and residues that are not drawn.
MeshPiece cartoon(const Molecule& molecule, std::span<const std::uint8_t> drawn, std::span<const std::uint32_t> colours,
                  const MoleculeStructure& structure);

/// True if a residue is part of the ribbons; other residues need another style.
bool inCartoon(const Residue& residue);

}  // namespace moltact
