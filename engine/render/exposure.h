// How open to the sky each atom lies: the cheap ambient occlusion that makes pockets dark and ridges bright.
// Pure function; memory and time follow the number of atoms and the extent (at most 192 voxels along an axis).
#pragma once

#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "engine/core/ball.h"

namespace moltact {

/// The light that reaches an atom's surface at the normal n is clamp(level + dot(slope, n), 0, 1).
struct Exposure {
  glm::vec3 slope{0.0f};
  float level = 1.0f;
};

/// One exposure a ball, from the smoothed density of all balls about it (own method: a blurred voxel field of the balls'
/// volume at two widths, taken to first order about each centre). Balls alone in space get full light.
std::vector<Exposure> exposures(std::span<const Ball> balls);

}  // namespace moltact
