// A unit sphere in triangles, with all that a constraint tracker needs: planes, the neighbour across each edge, and a
// tree of bounding boxes. One mesh serves every sphere: a sphere's triangles are the mesh's, scaled by its radius about its
// centre, so no sphere needs triangles of its own.
//
// All vertices lie on the sphere, as in the paper's meshes: the mesh is inscribed, and its faces lie up to the sagitta
// (sagitta()) under the true surface. It is convex, so every edge falls away from both its faces. Made before touching;
// immutable, so every thread may read it. Lengths are in units of the sphere's radius.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "engine/core/units.h"

namespace moltact {

class SphereMesh {
 public:
  /// 80, 320, 1280 or 5120 triangles: an icosahedron subdivided one to four times. 960, as in the paper: 16 bands of
  /// latitude by 32 of longitude, the poles' bands in triangles, the others in pairs of them; its 2 x 32 x 15 triangles
  /// have the most equal edges. Any other count is a programming error (asserted). Meshes are kept: a second call for
  /// the same count costs nothing.
  static std::shared_ptr<const SphereMesh> ofTriangles(int count);

  struct Face {
    Vec3 normal{0.0};                      ///< unit, outward
    double height = 0.0;                   ///< the plane is dot(normal, x) = height
    std::array<Vec3, 3> out{};             ///< unit, in the plane, outward over edge k (from corner k to k + 1)
    std::array<double, 3> reach{};         ///< the triangle is dot(out[k], x) <= reach[k] in its plane
    std::array<std::int32_t, 3> across{};  ///< the face beyond edge k
    std::array<std::int32_t, 3> corners{};
  };

  const std::vector<Face>& faces() const { return faces_; }
  const std::vector<Vec3>& vertices() const { return vertices_; }
  /// 1 - the least height of a face: the greatest depth of the mesh under the sphere.
  double sagitta() const { return sagitta_; }
  /// The greatest angle between a face's normal and the sphere's over that face (unit: radian).
  double greatestTilt() const { return tilt_; }
  std::size_t bytes() const;

  struct Entry {
    double t = 1.0;
    std::int32_t face = -1;
  };
  /// The parameter t < `before` and the face at which the straight path from `from` to `from + path` first enters the
  /// mesh; face -1 if it does not. A start on a face (within kSkin) enters at t = 0 when the path leads into it.
  Entry enter(const Vec3& from, const Vec3& path, double before) const noexcept;

  /// The face that the ray from the centre in this direction (any length but zero) passes.
  std::int32_t faceToward(const Vec3& direction) const noexcept;

  /// A face near that one, from a table: a start for a search from face to face.
  std::int32_t faceAbout(const Vec3& direction) const noexcept;

  static constexpr double kSkin = 1e-10;

 private:
  struct Node {
    Vec3 low, high;
    std::int32_t first, count;  // a leaf's places in leaves_; inner nodes: count 0, the left child follows,
                                // `first` is the right one
  };
  explicit SphereMesh(int count);
  void addFace(std::int32_t a, std::int32_t b, std::int32_t c);
  void subdivide(int levels);
  void makeBands(int bands, int sectors);
  void finish();
  std::int32_t makeNode(std::int32_t first, std::int32_t count);

  std::vector<Vec3> vertices_;
  std::vector<Face> faces_;
  std::vector<Node> nodes_;
  std::vector<std::int32_t> leaves_;  // faces in the tree's order
  static constexpr int kTable = 12;   // cells along an edge of the cube round the sphere
  std::vector<std::int32_t> about_;   // the face in the middle of each cell of the cube's sides
  double sagitta_ = 0.0, tilt_ = 0.0;
};

}  // namespace moltact
