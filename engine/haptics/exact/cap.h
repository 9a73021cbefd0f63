// What one ball covers of another's sphere: a cap. Pure; haptic thread. Units: angstrom.
#pragma once

#include <cmath>

#include "engine/haptics/nearby_balls.h"

namespace moltact {

/// The unit directions x from the centre of sphere i with dot(way, x) > level lie in ball j: on sphere i the equation
/// |c_i + R_i x - c_j|^2 < R_j^2 is linear in x.
struct Cap {
  Vec3 way;         ///< from centre i to centre j
  double distance;  ///< its length
  double level;     ///< (d^2 + R_i^2 - R_j^2) / (2 R_i)
  bool cuts;        ///< false: the spheres do not meet, or in one point only, or one ball lies in the other

  Cap(const NearBall& i, const NearBall& j)
      : way(j.centre - i.centre),
        distance(glm::length(way)),
        level((distance * distance + (i.radius - j.radius) * (i.radius + j.radius)) / (2.0 * i.radius)),
        cuts(distance < i.radius + j.radius && std::abs(level) < distance) {}
};

/// True only where a place on sphere i would have to turn by more than `angle` (unit: radian) before it meets ball j. Without
/// a root: the place's power |p - c_j|^2 - R_j^2 is 2 R_i d times the way of its cosine to the rim's, and a cosine changes
/// by at most one a radian; d <= R_i + R_j.
inline bool farFrom(const NearBall& i, const NearBall& j, const Vec3& place, double angle) {
  const Vec3 m = place - j.centre;
  return glm::dot(m, m) > j.radius * j.radius + 2.0 * i.radius * angle * (i.radius + j.radius);
}

}  // namespace moltact
