// The boundary of a union of spheres as vertices and triangles, the raw data of SurfaceMesh. Built before touching;
// allocates. Units: angstrom; positions are relative to the given origin.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/haptics/sphere_grid.h"

namespace moltact {

struct UnionSurface {
  /// `corners`: indices of vertices. `sphere`: index of the sphere that the triangle lies on.
  struct Triangle {
    std::array<std::int32_t, 3> corners;
    std::int32_t sphere;
  };
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
};

/// `spacing_A`: spacing of the sampling grid. A scene wider than half a million spacings gets a larger one.
UnionSurface unionSurface(const SphereGrid& scene, double probe_A, double spacing_A, const Vec3& origin);

}  // namespace moltact
