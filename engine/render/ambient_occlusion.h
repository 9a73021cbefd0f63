// How open to the sky each atom lies: the cheap ambient occlusion that makes pockets dark and ridges bright.
// Pure function; memory and time follow the number of atoms and the extent (at most 192 voxels along an axis).
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "engine/core/ball.h"

namespace moltact {

/// The light that reaches an atom's surface at the normal n is clamp(level + dot(slope, n), 0, 1).
struct AmbientOcclusion {
  glm::vec3 slope{0.0f};
  float level = 1.0f;
};

/// One AmbientOcclusion for each ball, from the smoothed density of all balls about it (own method: a blurred voxel
/// field of the balls' volume at two widths, taken to first order about each centre). Balls alone in space get full
/// light.
std::vector<AmbientOcclusion> ambientOcclusion(std::span<const Ball> balls);

}  // namespace moltact
