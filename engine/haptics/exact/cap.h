// A cap: the part of one sphere's surface that another sphere covers. Pure functions; haptic thread. Units: angstrom.
#pragma once

#include <cmath>

#include "engine/haptics/nearby_spheres.h"

namespace moltact {

/// A point of sphere i in unit direction x from its centre lies in sphere j if dot(offset, x) > level. (On sphere i the
/// condition |c_i + R_i x - c_j|^2 < R_j^2 is linear in x.) With level >= |offset| no direction is covered, with level
/// < -|offset| every direction.
struct Cap {
  Vec3 offset;   ///< from centre i to centre j
  double level;  ///< (d^2 + R_i^2 - R_j^2) / (2 R_i)

  Cap(const NearSphere& i, const NearSphere& j)
      : offset(j.centre - i.centre),
        level((glm::dot(offset, offset) + (i.radius - j.radius) * (i.radius + j.radius)) / (2.0 * i.radius)) {}
};

/// The power of a point with respect to a sphere, |p - c|^2 - R^2; negative inside (unit: square angstrom).
inline double powerOf(const Vec3& place, const NearSphere& sphere) {
  const Vec3 m = place - sphere.centre;
  return glm::dot(m, m) - sphere.radius * sphere.radius;
}

/// True only if a point on sphere i, with this power with respect to sphere j, must rotate by more than `angle` (unit:
/// radian) to reach sphere j. No square root is needed: the power is 2 R_i d times the difference between the point's
/// cosine and the cap's. A cosine changes by at most 1 per radian, and d <= R_i + R_j where the spheres meet.
inline bool farFrom(const NearSphere& i, const NearSphere& j, double power, double angle) {
  return power > 2.0 * i.radius * angle * (i.radius + j.radius);
}

}  // namespace moltact
