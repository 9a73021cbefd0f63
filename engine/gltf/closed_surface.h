// The surface of the union of spheres as closed triangles, for printing and slides. Pure function. Units: angstrom.
//
// A grid of cubes, each cut into six tetrahedra alike everywhere, so that neighbours share their edges and every edge
// of the result belongs to exactly two triangles: closed, without holes or flaps. Corners lie within step^2 / (2 r) of
// the surface of a sphere of radius r; creases are cut off by at most a step. Voids inside give surfaces of their own.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "engine/core/sphere.h"

namespace moltact {

struct ClosedSurface {
  std::vector<glm::vec3> places;         ///< relative to `middle_A`
  std::vector<glm::vec3> normals;        ///< outward, of the sphere that each place lies on
  std::vector<std::uint32_t> triangles;  ///< three indices each, counter-clockwise seen from outside
  std::vector<std::uint32_t> owners;     ///< for each triangle the sphere that it lies on
  Vec3 middle_A{0.0};
};

/// The most cells of the box round the spheres that are examined.
inline constexpr double kMaxCells = 64e6;

/// The step that gives the longest side 100 cells, but none finer than 0.15 A: some 400 000 triangles for a protein.
double usualStep_A(std::span<const Sphere> spheres);

/// How many cells a step would take.
double cellCount(std::span<const Sphere> spheres, double step_A);

/// Spheres without a positive radius are left out. `step_A` must be positive and cellCount() at most kMaxCells.
ClosedSurface closedSurface(std::span<const Sphere> spheres, double step_A);

}  // namespace moltact
