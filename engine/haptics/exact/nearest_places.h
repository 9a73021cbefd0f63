// Points common to two or three spheres (paper, equations 2 to 7, in vectors). Haptic thread. Units: angstrom.
#pragma once

#include <cmath>

#include "engine/haptics/nearby_spheres.h"

namespace moltact {

// The point of the two spheres' intersection circle nearest to p. Returns false if there is no circle or p lies on its
// axis.
inline bool nearestOnCircle(const NearSphere& i, const NearSphere& j, const Vec3& p, Vec3& out) {
  const Vec3 between = j.centre - i.centre;
  const double d = glm::length(between);
  if (!(d > 0.0)) return false;
  const double x = (d * d + (i.radius - j.radius) * (i.radius + j.radius)) / (2.0 * d);
  const double r2 = (i.radius - x) * (i.radius + x);
  if (!(r2 > 0.0)) return false;
  const Vec3 axis = between / d, centre = i.centre + axis * x;
  Vec3 radial = p - centre;
  radial -= axis * glm::dot(radial, axis);
  const double far = glm::length(radial);
  if (!(far > 0.0)) return false;
  out = centre + radial * (std::sqrt(r2) / far);
  return true;
}

// The two points common to three spheres. Returns false if there are none.
inline bool commonPoints(const NearSphere& i, const NearSphere& j, const NearSphere& k, Vec3 out[2]) {
  const Vec3 u = j.centre - i.centre, v = k.centre - i.centre, w = glm::cross(u, v);
  const double w2 = glm::dot(w, w);
  if (!(w2 > 1e-20)) return false;
  const double a = 0.5 * (glm::dot(u, u) + (i.radius - j.radius) * (i.radius + j.radius));
  const double b = 0.5 * (glm::dot(v, v) + (i.radius - k.radius) * (i.radius + k.radius));
  const Vec3 foot = glm::cross(a * v - b * u, w) / w2;  // in the centres' plane: foot.u = a, foot.v = b
  const double h2 = i.radius * i.radius - glm::dot(foot, foot);
  if (h2 < 0.0) return false;
  const Vec3 off = w * std::sqrt(h2 / w2);
  out[0] = i.centre + foot + off;
  out[1] = i.centre + foot - off;
  return true;
}

}  // namespace moltact
