// The molecular surface that a probe can reach: the wall of the space that no probe sphere enters (the solvent-excluded
// surface of Richards 1977), as triangles. Where the probe touches one atom it is the atom's own sphere; in creases and
// pits it is the probe's, so what is seen is what the probe feels.
//
// Method: a distance field. The surface on which the probe's middle moves (the spheres grown by the probe) is found
// where it crosses the edges of a grid, by the sphere's own equation; the surface lies a probe's radius inside it, so
// each node takes the distance to the nearest place of it, on a sphere or on an arc in which two spheres meet, and where
// that equals the probe's radius the triangles run (surface nets, Gibson 1998). Pure functions; any thread but
// the haptic one. Units: angstrom.
#pragma once

#include <atomic>
#include <span>

#include "engine/core/sphere.h"
#include "engine/render/mesh_piece.h"

namespace moltact {

/// The triangles, and for each vertex the sphere whose surface is nearest and the one after it.
struct SolventExcluded {
  MeshPiece piece;  ///< its colours are white
  std::vector<std::uint32_t> owner, second;
  std::vector<float>
      share;  ///< of the second in a colour that passes smoothly from one to the other: 0.5 where both are as near
  double step_A = 0.0;  ///< of the grid
};

/// How far a surface is, for the thread that waits for it, which may also end the work.
struct SurfaceProgress {
  std::atomic<float> share{0.0f};      ///< of the work, 0 to 1
  std::atomic<bool> cancelled{false};  ///< nobody wants it any more
};

/// `probe_A` must be positive. The grid's step is 0.5 A; coarser where an axis would have more than 200 nodes, or where the
/// grown spheres would hold more than 1.2 thousand million nodes together. Empty where it was cancelled.
SolventExcluded solventExcluded(std::span<const Sphere> spheres, double probe_A, SurfaceProgress* progress = nullptr);

}  // namespace moltact
