// One closed mesh of the solvent-accessible surface: the boundary of the union of all spheres, inflated by the probe,
// without triangles buried in other spheres. It contains the data that a constraint tracker needs: the neighbour across
// each edge and a tree of bounding boxes.
//
// Construction: the union is sampled at the nodes of a grid. Every cell whose corners differ gets a vertex for each
// sheet of the surface inside it. Every grid edge whose ends differ gets a polygon of the vertices around it (dual
// marching cubes: Ju et al. 2002, Nielson 2004). A vertex is projected onto the sphere of its sheet. Where a crease or
// pit of two or three spheres passes through the cell, the vertex lies on their circle or point. The triangles
// therefore end at the creases and cut no corner.
//
// On a face of the grid with four crossings each of the two segments gets a vertex. The mesh is thus manifold: every
// edge has two triangles. A gap or bridge narrower than a cell may be missed or closed.
//
// Built before touching, for one probe radius; immutable, so every thread may read it. Units: angstrom; positions are
// relative to the given origin.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "engine/haptics/sphere_grid.h"

namespace moltact {

class SurfaceMesh {
 public:
  struct Triangle {
    std::array<std::int32_t, 3> corners;  ///< indices of vertices, counter-clockwise seen from outside
    std::array<std::int32_t, 3> across;   ///< the triangle across the edge from corner k to k + 1
    std::int32_t sphere;                  ///< the sphere whose surface it approximates
  };
  /// A triangle's plane and borders.
  struct Plane {
    Vec3 normal{0.0};               ///< unit, outward
    double height = 0.0;            ///< dot(normal, x) = height
    std::array<Vec3, 3> out{};      ///< unit, in the plane, perpendicular to edge k, outward
    std::array<double, 3> reach{};  ///< a point of the plane is inside if dot(out[k], x) <= reach[k]
  };

  /// Returns the mesh of a scene. The last mesh of each spacing is cached for the same scene and probe.
  static std::shared_ptr<const SurfaceMesh> of(const std::shared_ptr<const SphereGrid>& scene, double probe_A,
                                               double spacing_A, const Vec3& origin);

  SurfaceMesh(const SphereGrid& scene, double probe_A, double spacing_A, const Vec3& origin);

  const std::vector<Vec3>& vertices() const { return vertices_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  Plane plane(std::int32_t triangle) const noexcept;
  std::size_t spheres() const { return spheres_; }  ///< number of spheres that contribute to the surface
  std::size_t bytes() const;

  struct Hit {
    double t = 1.0;
    std::int32_t triangle = -1;
  };
  /// The first triangle that the straight path from `from` to `from + path` enters from outside; triangle -1 if there
  /// is none.
  Hit cast(const Vec3& from, const Vec3& path) const noexcept;

  static constexpr double kSkin_A = 1e-9;  ///< a point within this distance of a plane lies on it

 private:
  struct Box {
    std::array<float, 3> low, high;
  };
  static constexpr std::int32_t kLeaf = 4;
  void sortByPlace();
  void findNeighbours();
  void makeTree();
  std::int32_t makeNode(std::int32_t first, std::int32_t count);

  std::vector<Vec3> vertices_;
  std::vector<Triangle> triangles_;
  struct Node {
    Box box;
    std::int32_t first,
        count;  // leaf: range of triangles; inner node: count 0, left child next, right child at `first`
  };
  std::vector<Node> nodes_;
  std::size_t spheres_ = 0;
};

}  // namespace moltact
