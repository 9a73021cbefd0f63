// The molecular surface that a probe can reach: the boundary of the space that no probe sphere enters (the
// solvent-excluded surface of Richards 1977), as triangles. Where the probe touches one atom it is the atom's sphere;
// in creases and pits it is the probe's sphere.
//
// Method: a distance field. The accessible surface (the spheres inflated by the probe) is located where it crosses the
// edges of a grid, by the equation of the sphere. The molecular surface lies one probe radius inside it. Therefore each
// node stores the distance to the nearest point of the accessible surface, on a sphere or on an intersection arc. The
// triangles follow the level at the probe radius (surface nets, Gibson 1998). Pure functions; any thread except the
// haptic one. Units: angstrom.
#pragma once

#include <atomic>
#include <span>

#include "engine/core/sphere.h"
#include "engine/render/mesh_piece.h"

namespace moltact {

/// The triangles, and for each vertex the spheres with the nearest and the second nearest surface.
struct SolventExcluded {
  MeshPiece piece;  ///< in white
  std::vector<std::uint32_t> owner, second;
  /// Weight of `second` in a smoothly blended colour: 0.5 where both are equally near.
  std::vector<float> share;
  double step_A = 0.0;  ///< spacing of the grid
};

/// The progress of a surface, shared with the waiting thread, which may cancel the work.
struct SurfaceProgress {
  std::atomic<float> share{0.0f};      ///< completed fraction, 0 to 1
  std::atomic<bool> cancelled{false};  ///< set by the waiting thread
};

/// Computes the surface. `probe_A` must be positive. The grid spacing is 0.5 A, or more if an axis would have more than
/// 200 nodes or the inflated spheres would contain more than `max_nodes_in_spheres` nodes together. Empty if cancelled.
SolventExcluded solventExcluded(std::span<const Sphere> spheres, double probe_A, SurfaceProgress* progress = nullptr,
                                double max_nodes_in_spheres = 1.2e9);

}  // namespace moltact
