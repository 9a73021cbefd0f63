// How much of the molecule lies about each place: from it the shader takes how open a point of a surface lies to the sky,
// so that creases, pits and pockets are dark and ridges bright, at every point and not once for an atom. Own method: the
// volume of the spheres in voxels, smoothed at two widths. Pure function; memory and time follow the number of spheres and
// the extent (at most 160 voxels along an axis). Units: angstrom.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "engine/core/sphere.h"

namespace moltact {

/// The filled share of space about each place, smoothed, in voxels: x runs fastest, then y.
struct OcclusionLevel {
  glm::ivec3 size{1};
  double voxel_A = 1.0;
  std::vector<std::uint8_t> filled{0};  ///< 0 empty to 255 filled

  /// Between the voxels' middles, 0 to 1; `place` from the field's low corner. The border's value beyond it.
  double at(const Vec3& place) const;
};

struct OcclusionField {
  Vec3 low_A{0.0};            ///< the corner of both levels
  OcclusionLevel fine, wide;  ///< smoothed over about 1 A and 4 A; one empty voxel in a scene too wide for it

  /// Nothing is in the light's way: a scene of one sphere, or one too wide to tell.
  bool empty() const { return fine.filled.size() == 1 && wide.filled.size() == 1; }
  /// What of the wide level lies round a sphere: w + dot(xyz, normal) is about what wide.at() gives outside its surface
  /// there, since that level hardly changes over an atom.
  glm::vec4 wideRound(const Vec3& centre_A, double radius_A) const;
  /// The light from all sides that reaches a place of a surface with this normal, 0 to 1: what the shaders compute.
  double open(const Vec3& place_A, const Vec3& normal) const;
};

/// How far outside the surface the levels are looked up (unit: angstrom), and which filled share is none and all of the
/// shade there: of the places of a protein that are in sight, a tenth have less than the least, one in fifty more than
/// the most.
inline constexpr double kFineOut_A = 0.7, kWideOut_A = 2.5;
inline constexpr double kFineLeast = 0.12, kFineMost = 0.52, kWideLeast = 0.06, kWideMost = 0.44;
inline constexpr double kFineShade = 0.74, kWideShade = 0.62;

OcclusionField occlusionField(std::span<const Sphere> spheres);

}  // namespace moltact
