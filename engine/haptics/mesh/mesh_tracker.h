// The god-object method on triangles. Every inflated sphere is a mesh. The SCP stays outside all meshes and descends |x
// - h|^2 toward the HIP h; up to three faces block it at once (Zilles & Salisbury 1995). At an edge it continues on the
// neighbouring face (neighbour tracking, Ho, Basdogan & Srinivasan 1999). Every tick follows the motion to its end, so
// there is no lag: the only error is that of the triangles.
//
// The design is optimized for speed:
// * One mesh serves all spheres (sphere_mesh.h). It is scaled and moved to a sphere while that sphere is examined. A
//   tracker with a mesh per sphere, as in the paper, needs SphereMesh::bytes() per sphere; wholeMoleculeBytes()
//   returns the total.
// * The scene's grid finds the meshes near the path by their bounding spheres; the mesh's tree of boxes then finds the
//   face. The spheres near the SCP and the distance to the next sphere are cached between ticks.
// * The meshes that the SCP touches are not searched: a mesh is convex, and the path never leads under the touched
//   face.
// * The fast path covers an SCP on one face, on the seam of two or at rest on three. It gives the result of the full
//   step and tests only whether another mesh is near. A nearby mesh is excluded by its bounding sphere or by one plane,
//   the last one that excluded it or one close to it.
//
// `coherent = false` caches nothing: every tick queries the grid and the trees again, as published polygonal trackers
// do. The results are bitwise identical.
//
// Force shading: with `smooth` the displacement (Contact::displacement_A) keeps its length but is rotated to a normal
// interpolated from the corners' normals (Ruspini, Kolarov & Khatib 1997). Several blocking faces are weighted by their
// shares in the contact. The corners carry the sphere's own normals, whose interpolation over a face is the direction
// from the centre; no shading is more accurate.
//
// Known limitations, verified by tests: at an edge the SCP jumps by about twice the depth times the tangent of half the
// angle between the faces. The unshaded force rotates by that angle. The SCP lies up to one sagitta under the true
// surface. A gap between spheres narrower than two sagittas is open. Feature and atoms describe the blocking spheres.
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
    int triangles = 960;   ///< per sphere: 80, 320, 960, 1280 or 5120
    bool smooth = false;   ///< force shading
    bool coherent = true;  ///< cache the surroundings between ticks
  };

  MeshTracker(std::shared_ptr<const SphereGrid> scene, double probe_A, Options options);

  Contact step(PointA hip) noexcept override;
  void reset() noexcept override;
  void setProbe(double probe_A) noexcept override;
  bool setMotion(const SphereMotion* motion) noexcept override;
  void advanceTo(double fraction) noexcept override;
  double probe_A() const noexcept override { return nearby_.probe_A(); }
  /// Counts the shared mesh in full for each tracker. Atoms modelled: those whose meshes the SCP touches.
  MemoryUsage memoryUsage() const noexcept override;

  /// The mesh of a sphere of radius 1. To draw it, scale and move it to each sphere.
  const SphereMesh& mesh() const noexcept { return *mesh_; }

  /// The memory of one mesh for each of that many spheres, without the tree over them (unit: byte).
  std::size_t wholeMoleculeBytes(std::size_t spheres) const noexcept { return spheres * mesh_->bytes(); }

  /// Number of ticks that were cut short, because the motion needed more than kMaxPieces pieces or made no progress.
  /// The SCP then lags, outside.
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
    std::int32_t face;  // a face whose plane may separate the mesh from the SCP; -1: none known
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
  Vec3 scp_{0.0};                  // like every position inside the tracker, relative to nearby_.origin()
  bool has_been_outside_ = false;  // the HIP has been outside since the start
  std::array<Touch, kMaxTouching> touching_;
  int touch_count_ = 0;
  std::array<int, 3> holding_{};  // indices into touching_ of the blocking faces
  int hold_count_ = 0;
  bool quick_prepared_ = false;  // the SCP touches only the blocking faces; the next three members describe them
  Vec3 seam_{0.0};               // two or three faces: direction of the seam of the first two
  double seam_cosine_ = 0.0;
  std::array<Vec3, 3> holds_{};  // three faces: the SCP rests while the displacement points against each of these
  Vec3 free_from_{0.0};          // free: every sphere is at least free_gap_ from this point
  double free_gap_ = 0.0;
  Vec3 clear_from_{0.0};  // in contact: no sphere except those in touching_ is within clear_gap_ of this point
  double clear_gap_ = 0.0;
  std::array<NearbyMesh, kMaxNearbyMeshes> nearby_meshes_;  // the nearest spheres; no other is within nearby_mesh_gap_
  int nearby_mesh_count_ = 0;
  double nearby_mesh_gap_ = 0.0;
  std::uint64_t cut_short_ = 0;
};

}  // namespace moltact
