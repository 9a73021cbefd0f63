// Bonds as sticks or lines, and the spheres at their ends. Pure functions; any thread except the haptic one. Units:
// angstrom.
#pragma once

#include <cstdint>
#include <span>

#include "engine/molecule/molecule.h"
#include "engine/render/mesh_piece.h"

namespace moltact {

/// Adds a cylinder from a to b; `closed` adds a cap at both ends.
void addStick(MeshPiece& piece, const Vec3& a, const Vec3& b, double radius_A, std::uint32_t colour, bool closed);

/// The sticks of all bonds between drawn atoms, each half in its atom's colour (packColour).
MeshPiece sticks(const Molecule& molecule, std::span<const Bond> bonds, std::span<const std::uint8_t> drawn,
                 std::span<const std::uint32_t> colours, double radius_A);

}  // namespace moltact
