// A unit sphere made of triangles, with the data that a constraint tracker needs: planes, the neighbour across each
// edge and a tree of bounding boxes. One mesh serves every sphere: it is scaled by the sphere's radius about the
// centre.
//
// All vertices lie on the sphere, as in the paper's meshes. The mesh is inscribed, and its faces lie up to sagitta()
// under the true surface. It is convex. Built before touching and immutable, so every thread may read it. Unit of
// length: the sphere's radius.
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
  /// The mesh with that number of triangles. 80, 320, 1280 or 5120: an icosahedron subdivided one to four times. 960,
  /// as in the paper: 16 bands of latitude by 32 of longitude, with single triangles at the poles and pairs elsewhere:
  /// 2 x 32 x 15 in total. This division has the most equal edges. Any other count is a programming error (asserted).
  /// Meshes are cached.
  static std::shared_ptr<const SphereMesh> ofTriangles(int count);

  struct Face {
    Vec3 normal{0.0};                      ///< unit, outward
    double height = 0.0;                   ///< the plane is dot(normal, x) = height
    std::array<Vec3, 3> out{};             ///< unit, in the plane, perpendicular to edge k (corner k to k + 1), outward
    std::array<double, 3> reach{};         ///< the triangle is dot(out[k], x) <= reach[k], within its plane
    std::array<std::int32_t, 3> across{};  ///< the face across edge k
    std::array<std::int32_t, 3> corners{};
  };

  const std::vector<Face>& faces() const { return faces_; }
  const std::vector<Vec3>& vertices() const { return vertices_; }
  /// 1 minus the smallest height of a face: the largest depth of the mesh under the sphere.
  double sagitta() const { return sagitta_; }
  /// The largest angle between a face's normal and the sphere's normal over that face (unit: radian).
  double maxTilt() const { return tilt_; }
  std::size_t bytes() const;

  struct Entry {
    double t = 1.0;
    std::int32_t face = -1;
  };
  /// Intersects the straight path from `from` to `from + path` with the mesh. Returns the parameter t < `before` and
  /// the face of the first entry; face -1 if there is none. A start within kSkin of a face enters at t = 0 if the path
  /// leads into it.
  Entry enter(const Vec3& from, const Vec3& path, double before) const noexcept;

  /// The face that the ray from the centre in this direction (of any length above zero) intersects.
  std::int32_t faceToward(const Vec3& direction) const noexcept;

  /// A face near faceToward(direction), from a table, as the start of a search from face to face.
  std::int32_t faceAbout(const Vec3& direction) const noexcept;

  static constexpr double kSkin = 1e-10;

 private:
  struct Node {
    Vec3 low, high;
    std::int32_t first, count;  // leaf: range in leaves_; inner node: count 0, left child next, right child at `first`
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
  static constexpr int kTable = 12;   // cells along an edge of the bounding cube
  std::vector<std::int32_t> about_;   // the face at the middle of each cell of the cube's sides
  double sagitta_ = 0.0, tilt_ = 0.0;
};

}  // namespace moltact
