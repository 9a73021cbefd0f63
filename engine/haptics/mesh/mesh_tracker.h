// The god-object on triangles. Every inflated sphere is a mesh; the SCP stays outside all of them and goes down |x - h|^2
// toward the HIP h, held by up to three faces at once (Zilles & Salisbury 1995). Over an edge it goes on to the
// neighbouring face that the mesh names (neighbour tracking, Ho, Basdogan & Srinivasan 1999). Every motion within a
// tick is followed to its end, so there is no lag: the only error is that of the triangles.
//
// This is the fastest design we know that still uses triangles:
// * One mesh serves all spheres (sphere_mesh.h); it is scaled and moved to a sphere while that sphere is examined. A tracker
//   with a mesh for each sphere, as in the paper, needs SphereMesh::bytes() for each sphere of the molecule;
//   wholeMoleculeBytes() returns the total.
// * The scene's grid of spheres finds the meshes that may be met, each sphere as the bounding sphere of its mesh; then the
//   mesh's tree of boxes finds the face. The spheres near the SCP and the distance to the next sphere are remembered from
//   tick to tick.
// * A mesh that the SCP is on is not searched: it is convex, and the SCP's path does not lead under the face it is on.
// * The ordinary tick (on one face, along the seam of two, or at rest on the point of three) does what the whole flow
//   would do, and asks only whether anything else is near. A sphere near by is separated from the SCP's path by its
//   bounding sphere or by one plane of its mesh: the last plane that did so, or one close to it.
//
// `coherent = false` remembers nothing: every tick asks the grid and the trees again, box by box, as published
// polygonal trackers do. The places found are the same to the last bit.
//
// Force shading: with `smooth` the displacement (Contact::displacement_A) keeps its length and is rotated to a normal
// interpolated from the corners' normals (Ruspini, Kolarov & Khatib 1997), each weighted by its face's part in holding
// the SCP. Corners on the sphere have the sphere's own normals, and the interpolation of such normals over a face is
// the direction from the centre: no shading can do better.
//
// Known failures, pinned by tests: over an edge the SCP jumps by about twice the depth times the tangent of half the
// angle between the faces, and the flat force rotates by that angle; the SCP lies up to a sagitta under the true
// surface; a gap between spheres narrower than two sagittas is open. Feature and atoms: the spheres that hold the SCP.
// Haptic thread; no allocation after construction. Units: angstrom.
#pragma once

#include <array>
#include <memory>

#include "engine/haptics/mesh/sphere_mesh.h"
#include "engine/haptics/nearby_spheres.h"
#include "engine/haptics/tracker.h"

namespace moltact {

class MeshTracker final : public Tracker {
 public:
  struct Options {
    int triangles = 960;   ///< a sphere: 80, 320, 960, 1280 or 5120
    bool smooth = false;   ///< force shading
    bool coherent = true;  ///< remember the surroundings from tick to tick
  };

  MeshTracker(std::shared_ptr<const SphereGrid> scene, double probe_A, Options options);

  Contact step(PointA hip) noexcept override;
  void reset() noexcept override;
  void setProbe(double probe_A) noexcept override;
  bool setMotion(const SphereMotion* motion) noexcept override;
  void advanceTo(double fraction) noexcept override;
  double probe_A() const noexcept override { return nearby_.probe_A(); }
  /// The shared mesh is counted in full for each tracker. Atoms modelled: those whose meshes the SCP is on.
  MemoryUsage memoryUsage() const noexcept override;

  /// The mesh that is felt, for one sphere of radius 1; to draw it, scale and move it to each sphere.
  const SphereMesh& mesh() const noexcept { return *mesh_; }

  /// The memory of one mesh for each of that many spheres, without the tree over them.
  std::size_t wholeMoleculeBytes(std::size_t spheres) const noexcept { return spheres * mesh_->bytes(); }

  /// Ticks whose flow was cut short because it took more pieces than kMaxPieces or made no progress; the SCP then
  /// lags, outside.
  std::uint64_t cutShort() const noexcept { return cut_short_; }

  static constexpr int kMaxPieces = 512;

 private:
  static constexpr int kMaxTouching = 8;
  struct Touch {
    std::int32_t sphere, face;
    Vec3 centre;
    double radius;
  };
  struct NearbyMesh {
    NearSphere sphere;
    std::int32_t face;  // whose plane may separate it from the SCP; -1: none known
  };
  static constexpr std::size_t kNearbyMeshes = 4, kMaxNearbyMeshes = 8;
  struct Meeting {
    double t;
    NearSphere sphere;
    std::int32_t face;
  };

  const SphereMesh::Face& face(const Touch& t) const { return mesh_->faces()[std::size_t(t.face)]; }
  double heightOver(const Touch& t, const Vec3& place) const {
    return glm::dot(face(t).normal, place - t.centre) - face(t).height * t.radius;
  }
  bool touches(std::int32_t sphere) const;
  bool holdsQuickly(const Vec3& hip) noexcept;
  bool wellWithin(const Touch& t, const Vec3& place) const;
  void prepareQuickTicks() noexcept;
  bool isClear(const Vec3& end, double length) noexcept;
  bool staysAbove(NearbyMesh& other, const Vec3& end) const;
  void trackNearby(const Touch& t) noexcept;
  void flow(const Vec3& hip) noexcept;
  void meet(const Vec3& path, Meeting& first) noexcept;
  void removeSeparated() noexcept;
  bool pushOut() noexcept;
  bool carry() noexcept;
  void forgetSurroundings() noexcept { free_gap_ = clear_gap_ = nearby_mesh_gap_ = 0.0; }
  Vec3 shadedNormal(const Vec3& hip) const noexcept;
  Contact contact(const Vec3& hip) const noexcept;

  std::shared_ptr<const SphereMesh> mesh_;
  Options options_;
  NearbySpheres nearby_;
  Vec3 scp_{0.0};                  // this and every place inside the tracker is relative to nearby_.origin()
  bool has_been_outside_ = false;  // has the HIP been outside since the start?
  std::array<Touch, kMaxTouching> touching_;
  int touch_count_ = 0;
  std::array<int, 3> holding_{};  // places in touching_ of the faces that hold the SCP
  int hold_count_ = 0;
  bool quick_prepared_ = false;  // the SCP touches only the faces that hold it; the next three describe them
  Vec3 seam_{0.0};               // two or three hold: along the seam of the first two
  double seam_cosine_ = 0.0;
  std::array<Vec3, 3> holds_{};  // three hold: while the displacement leads against each of these
  Vec3 free_from_{0.0};          // free: no sphere is within free_gap_ of this place
  double free_gap_ = 0.0;
  Vec3 clear_from_{0.0};  // in contact: no sphere but the ones in touching_ is within clear_gap_ of this place
  double clear_gap_ = 0.0;
  std::array<NearbyMesh, kMaxNearbyMeshes> nearby_meshes_;  // the nearest spheres; no other is within nearby_mesh_gap_
  int nearby_mesh_count_ = 0;
  double nearby_mesh_gap_ = 0.0;
  std::uint64_t cut_short_ = 0;
};

}  // namespace moltact
