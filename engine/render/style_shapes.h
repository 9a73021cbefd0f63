// The shapes of a style: the geometry that represents atoms in a picture or an exported model. Pure functions; any
// thread except the haptic one. Units: angstrom.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/sphere.h"
#include "engine/molecule/draw_style.h"
#include "engine/molecule/molecule.h"
#include "engine/render/mesh_piece.h"
#include "engine/render/solvent_excluded.h"
#include "engine/structure/found_structure.h"

namespace moltact {

/// A sphere at an atom with the style's own radius.
struct SmallSphere {
  std::uint32_t atom;
  float radius_A;
  glm::vec4 wide{0.0f};  ///< OcclusionField::wideRound in the style's own light, set later
};

struct StyleShapes {
  MeshPiece piece;
  std::vector<SmallSphere> spheres;  ///< empty for the style Spheres, which uses the atoms' radii
  std::vector<Sphere> shading;       ///< the spheres that occlude ambient light
};

/// The surface that a probe of this radius (at least 0.2) can reach of the atoms with nonzero `shown`; its owners are
/// atoms of the molecule.
SolventExcluded surfaceOf(const Molecule& molecule, std::span<const std::uint8_t> shown, double probe_A,
                          SurfaceProgress* progress = nullptr);

/// The shapes of the shown atoms in their colours (packColour). `surface` is surfaceOf() of the same atoms if
/// DrawStyleInfo::uses_probe is set, else empty.
StyleShapes shapesOf(DrawStyle style, const Molecule& molecule, std::span<const std::uint8_t> shown,
                     std::span<const std::uint32_t> colours, const SolventExcluded& surface, FoundStructure& found);

}  // namespace moltact
