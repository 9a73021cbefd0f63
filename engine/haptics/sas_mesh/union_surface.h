// The border of a union of balls as vertices and triangles: the making of SurfaceMesh. Before touching; allocates.
// Units: angstrom; places relative to the origin given.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/haptics/ball_scene.h"

namespace moltact {

struct UnionSurface {
  struct Triangle {
    std::array<std::int32_t, 3> corners;
    std::int32_t ball;
  };
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
};

/// `spacing_A`: of the grid that the union is sampled on; more for a scene wider than half a million of them.
UnionSurface unionSurface(const BallScene& scene, double probe_A, double spacing_A, const Vec3& origin);

}  // namespace moltact
