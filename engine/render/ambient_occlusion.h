// Ambient occlusion: the density of the molecule around each point, from which the shader computes how exposed a point
// of a surface is. Creases, pits and pockets become dark and ridges bright, per pixel and not per atom. The method is
// specific to this program: the volume of the spheres in voxels, smoothed at two widths. Pure function; memory and time
// are proportional to the number of spheres and to the extent (at most 160 voxels along an axis). Units: angstrom.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "engine/core/sphere.h"

namespace moltact {

/// The smoothed filled fraction of space in voxels; x varies fastest, then y.
struct OcclusionLevel {
  glm::ivec3 size{1};
  double voxel_A = 1.0;
  std::vector<std::uint8_t> filled{0};  ///< 0 empty to 255 filled

  /// Interpolates between the voxels' centres, 0 to 1. `place` is relative to the field's low corner. Outside the field
  /// it returns the value at the border.
  double at(const Vec3& place) const;
};

struct OcclusionField {
  Vec3 low_A{0.0};            ///< low corner of both levels
  OcclusionLevel fine, wide;  ///< smoothed over about 1 A and 4 A; one empty voxel in a scene that is too wide

  /// True if nothing occludes: a scene of one sphere, or one that is too wide.
  bool empty() const { return fine.filled.size() == 1 && wide.filled.size() == 1; }
  /// A linear approximation of the wide level around a sphere: w + dot(xyz, normal) approximates wide.at() outside its
  /// surface. It suffices because that level hardly changes over an atom.
  glm::vec4 wideRound(const Vec3& centre_A, double radius_A) const;
  /// The ambient light at a point of a surface with this normal, 0 to 1, as the shaders compute it.
  double open(const Vec3& place_A, const Vec3& normal) const;
};

/// The distance outside the surface at which the levels are sampled (unit: angstrom), and the filled fractions that
/// give no shade and full shade. Of the visible points of a protein, one in ten has less than the minimum and one in
/// fifty more than the maximum.
inline constexpr double kFineOut_A = 0.7, kWideOut_A = 2.5;
inline constexpr double kMinFineFill = 0.12, kMaxFineFill = 0.52, kMinWideFill = 0.06, kMaxWideFill = 0.44;
/// The fraction of the ambient light that full shade of each level removes.
inline constexpr double kFineShade = 0.74, kWideShade = 0.62;

OcclusionField occlusionField(std::span<const Sphere> spheres);

}  // namespace moltact
