// The god-object method on one manifold mesh of the solvent-accessible surface (surface_mesh.h): an upper bound for
// polygonal trackers, with everything prepared in advance. In flight the SCP moves straight to the HIP, and the mesh's
// tree of boxes finds the first triangle on the path. In contact the SCP descends |x - h|^2 from triangle to triangle
// (neighbour tracking, Ho, Basdogan & Srinivasan 1999). It moves on a triangle, along an edge in a crease or from a
// corner, always along the steepest path that stays outside. The mesh has no inner faces and no self-intersections, so
// contact requires no search.
//
// The mesh is valid for one probe radius; setProbe() does nothing. Known limitations, verified by tests: at an edge of
// a facet the SCP lags and then jumps, and the force rotates by the angle between the facets. A gap narrower than a
// cell of the mesh's grid may be closed, and a sphere smaller than a cell missed. The feature is always Sphere, with
// the triangle's sphere. Haptic thread; no allocation after construction. Units: angstrom.
#pragma once

#include <memory>

#include "engine/bench/methods/surface_mesh.h"
#include "engine/haptics/tracker.h"

namespace moltact {

class SasMeshTracker final : public Tracker {
 public:
  SasMeshTracker(std::shared_ptr<const SphereGrid> scene, double probe_A, double spacing_A);

  Contact step(PointA hip) noexcept override;
  void reset() noexcept override;
  void setProbe(double) noexcept override {}
  double probe_A() const noexcept override { return probe_; }
  /// Atoms modelled: all that contribute to the surface.
  MemoryUsage memoryUsage() const noexcept override;

  const SurfaceMesh& mesh() const noexcept { return *mesh_; }
  /// Number of ticks in which the SCP did not come to rest; it then lags, outside.
  std::uint64_t cutShort() const noexcept { return cut_short_; }

  static constexpr int kMaxPieces = 512;

 private:
  enum class On : std::uint8_t { Nothing, Triangle, Edge, Corner };
  enum class SlideResult : std::uint8_t { Arrived, Meets, Leaves, Rests, Short };
  static constexpr std::size_t kMaxRound = 32;  // triangles around a corner
  struct Wedge {                                // one of these triangles, with its right edge as seen from outside
    std::int32_t triangle;
    std::int32_t edge;  // of the triangle, from the corner
    Vec3 normal, along, in_right, in_left;
  };

  SlideResult fly(const Vec3& hip) noexcept;
  SlideResult walk(const Vec3& hip) noexcept;
  SlideResult overTriangle(const Vec3& hip, int& stuck) noexcept;
  SlideResult alongEdge(const Vec3& hip, int& stuck) noexcept;
  SlideResult fromCorner(const Vec3& hip, int& stuck) noexcept;
  Vec3 outward() const noexcept;
  void goToTriangle(std::int32_t triangle) noexcept;
  void goToEdge(std::int32_t triangle, std::int32_t edge) noexcept;
  void goToCorner(std::int32_t triangle, std::int32_t corner) noexcept;

  std::shared_ptr<const SphereGrid> scene_;
  double probe_, margin_;
  Vec3 origin_;
  std::shared_ptr<const SurfaceMesh> mesh_;
  Vec3 scp_{0.0};                  // like every position inside the tracker, relative to origin_
  bool has_been_outside_ = false;  // the HIP has been outside since the start
  On on_ = On::Nothing;
  std::int32_t triangle_ = -1, edge_ = 0;
  SurfaceMesh::Plane plane_;   // of the triangle
  SurfaceMesh::Plane beyond_;  // on an edge: of the other triangle
  std::int32_t other_ = -1;
  std::size_t other_edge_ = 0;
  Vec3 edge_from_{0.0}, edge_along_{0.0};
  double edge_length_ = 0.0;
  std::array<Wedge, kMaxRound> round_;  // on a corner
  std::size_t round_count_ = 0;
  Vec3 corner_normal_{0.0};
  Vec3 free_from_{0.0};  // free: the mesh is at least free_gap_ from this point
  double free_gap_ = 0.0;
  std::uint64_t cut_short_ = 0;
};

}  // namespace moltact
