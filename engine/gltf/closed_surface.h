// The surface of the union of spheres as closed triangles, for 3D printing and slides. Pure functions. Units: angstrom.
//
// Method: a grid of cubes, each divided into six tetrahedra in the same way. Neighbours share their edges, so every
// edge of the result belongs to exactly two triangles. The surface is closed. Vertices lie within step^2 / (2 r) of the
// surface of a sphere of radius r; creases are cut off by at most one step. Internal voids give separate surfaces.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "engine/core/sphere.h"

namespace moltact {

struct ClosedSurface {
  std::vector<glm::vec3> places;         ///< relative to `middle_A`
  std::vector<glm::vec3> normals;        ///< outward normals of the sphere at each vertex
  std::vector<std::uint32_t> triangles;  ///< three indices each, counter-clockwise seen from outside
  std::vector<std::uint32_t> owners;     ///< for each triangle, the sphere on which it lies
  Vec3 middle_A{0.0};
};

/// Limit on the number of cells in the bounding box of the spheres.
inline constexpr double kMaxCells = 64e6;

/// A step that divides the longest side into 100 cells, but at least 0.15 A: about 400 000 triangles for a protein.
double usualStep_A(std::span<const Sphere> spheres);

/// The number of cells at a given step.
double cellCount(std::span<const Sphere> spheres, double step_A);

/// Computes the surface. Spheres without a positive radius are ignored. `step_A` must be positive and cellCount() at
/// most kMaxCells.
ClosedSurface closedSurface(std::span<const Sphere> spheres, double step_A);

}  // namespace moltact
