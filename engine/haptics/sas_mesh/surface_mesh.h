// One closed mesh of the solvent-accessible surface: the boundary of the union of all spheres, inflated by the probe,
// without the triangles that lie buried in other spheres. It has all that a constraint tracker needs: the neighbour
// across each edge and a tree of bounding boxes.
//
// How it is made: the union is sampled at the nodes of a grid. Every cell whose corners differ gets a vertex for each
// sheet of the surface that passes through it, and every grid edge whose ends differ gets a polygon of the vertices
// round it (dual marching cubes: Ju and others 2002, Nielson 2004). A vertex is put on the sphere that its sheet
// belongs to; where a crease or pit of two or three spheres passes through the cell, it is put on their circle or point.
// So the triangles end at the creases, and no corner is cut. Where a face of the grid has four crossings, their two
// segments get a vertex each, so that the mesh is a manifold: every edge has two triangles. A gap or a bridge narrower
// than a cell may be missed or closed.
//
// Made before touching, for one probe; immutable, so every thread may read it. Units: angstrom; places relative to the
// given origin.
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
    std::array<std::int32_t, 3> corners;  ///< vertices, the right way round seen from outside
    std::array<std::int32_t, 3> across;   ///< the triangle beyond the edge from corner k to k + 1
    std::int32_t sphere;                  ///< whose surface it is a part of
  };
  /// A triangle's plane and borders.
  struct Plane {
    Vec3 normal{0.0};               ///< unit, outward
    double height = 0.0;            ///< dot(normal, x) = height
    std::array<Vec3, 3> out{};      ///< unit, in the plane, outward over edge k
    std::array<double, 3> reach{};  ///< inside: dot(out[k], x) <= reach[k]
  };

  /// The last mesh of each spacing is kept: asking again for the same scene and probe costs nothing.
  static std::shared_ptr<const SurfaceMesh> of(const std::shared_ptr<const SphereGrid>& scene, double probe_A,
                                               double spacing_A, const Vec3& origin);

  SurfaceMesh(const SphereGrid& scene, double probe_A, double spacing_A, const Vec3& origin);

  const std::vector<Vec3>& vertices() const { return vertices_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  Plane plane(std::int32_t triangle) const noexcept;
  std::size_t spheres() const { return spheres_; }  ///< the spheres that have a part in the surface
  std::size_t bytes() const;

  struct Hit {
    double t = 1.0;
    std::int32_t triangle = -1;
  };
  /// The first triangle that the straight path from `from` to `from + path` enters from outside; triangle -1 if there
  /// is none.
  Hit cast(const Vec3& from, const Vec3& path) const noexcept;

  static constexpr double kSkin_A = 1e-9;  ///< a place so near a plane is on it

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
        count;  // a leaf's triangles; inner nodes: count 0, the left child follows, `first` is the right one
  };
  std::vector<Node> nodes_;
  std::size_t spheres_ = 0;
};

}  // namespace moltact
