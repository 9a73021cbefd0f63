// The cartoon of a molecule: a ribbon along each chain's backbone, wide in helices, an arrow for each strand, a tube
// elsewhere; for nucleic acid a band with a rung toward each base's partner. Pure functions; any thread but the haptic
// one. Units: angstrom.
#pragma once

#include <cstdint>
#include <span>

#include "engine/molecule/molecule.h"
#include "engine/render/mesh_piece.h"
#include "engine/structure/secondary_structure.h"

namespace moltact {

/// Half the ribbon's width and thickness by what it stands for.
inline constexpr double kHelixWidth_A = 1.35, kStrandWidth_A = 1.1, kArrowWidth_A = 1.9, kFlat_A = 0.28, kTube_A = 0.32;

/// `structure` is the secondary structure of the molecule. `drawn[a]` says which atoms belong to the picture: a residue is
/// drawn where its CA (or the nucleotide's phosphorus) is. Each residue has the colour (packColour) of that atom. A chain that ends, has a gap or is not drawn further is closed.
MeshPiece cartoon(const Molecule& molecule, std::span<const std::uint8_t> drawn, std::span<const std::uint32_t> colours,
                  const MoleculeStructure& structure);

/// Whether a residue is part of the ribbons: what is not is shown in another way.
bool inCartoon(const Residue& residue);

}  // namespace moltact
