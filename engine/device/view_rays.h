// Rays from the eye through the pixels of a view, for pointing at a molecule. Units: angstrom, pixel.
#pragma once

#include <cmath>

#include "engine/core/units.h"

namespace moltact {

struct ViewRays {
  Vec3 eye_A{0, 0, 50};
  Vec3 forward{0, 0, -1}, right{1, 0, 0}, up{0, 1, 0};  ///< orthonormal, in the molecule's space
  double tan_half_fov = 0.3;                            ///< of the vertical field of view
  double width_px = 1, height_px = 1;

  /// The unit direction through a pixel; the origin is the upper left corner.
  Vec3 direction(glm::dvec2 px) const {
    const double scale = 2.0 * tan_half_fov / height_px;
    return glm::normalize(forward + right * ((px.x - 0.5 * width_px) * scale) +
                          up * ((0.5 * height_px - px.y) * scale));
  }

  /// The pixel at which a point is visible. Undefined for points behind the eye.
  glm::dvec2 pixel(const Vec3& place_A) const {
    const Vec3 d = place_A - eye_A;
    const double scale = height_px / (2.0 * tan_half_fov * glm::dot(d, forward));
    return {0.5 * width_px + glm::dot(d, right) * scale, 0.5 * height_px - glm::dot(d, up) * scale};
  }
};

}  // namespace moltact
