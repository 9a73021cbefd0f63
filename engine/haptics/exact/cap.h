// What one sphere covers of another's sphere: a cap. Pure; haptic thread. Units: angstrom.
#pragma once

#include <cmath>

#include "engine/haptics/nearby_spheres.h"

namespace moltact {

/// The unit directions x from the centre of sphere i with dot(offset, x) > level lie in sphere j: on sphere i the
/// equation |c_i + R_i x - c_j|^2 < R_j^2 is linear in x. With level >= |offset| none does, with level < -|offset| all
/// do.
struct Cap {
  Vec3 offset;   ///< from centre i to centre j
  double level;  ///< (d^2 + R_i^2 - R_j^2) / (2 R_i)

  Cap(const NearSphere& i, const NearSphere& j)
      : offset(j.centre - i.centre),
        level((glm::dot(offset, offset) + (i.radius - j.radius) * (i.radius + j.radius)) / (2.0 * i.radius)) {}
};

/// The power of a place in a sphere, |p - c|^2 - R^2: under 0 inside (unit: square angstrom).
inline double powerOf(const Vec3& place, const NearSphere& sphere) {
  const Vec3 m = place - sphere.centre;
  return glm::dot(m, m) - sphere.radius * sphere.radius;
}

/// True only where a place on sphere i with this power in sphere j would have to rotate by more than `angle` (unit:
/// radian) before it meets that sphere. Without a root: the power is 2 R_i d times the difference between its cosine and
/// the rim's, and a cosine changes by at most one a radian; d <= R_i + R_j where the two meet.
inline bool farFrom(const NearSphere& i, const NearSphere& j, double power, double angle) {
  return power > 2.0 * i.radius * angle * (i.radius + j.radius);
}

}  // namespace moltact
