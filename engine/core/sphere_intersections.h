// Intersections of spheres: the circle of two and the points of three. Pure functions; any thread; they neither
// allocate nor throw. Units: angstrom. Two trackers have versions of their own: that of the paper as published
// (haptics/paper), and that of the exact tracker, which keeps state between ticks (haptics/exact).
#pragma once

#include <array>
#include <cmath>
#include <optional>

#include "engine/core/sphere.h"

namespace moltact {

struct SphereCircle {
  Vec3 centre_A{0.0}, axis{0, 0, 1};  ///< the axis is a unit vector from the first sphere to the second
  double radius_A = 0.0;
};

/// The sphere inflated by a probe.
inline Sphere inflated(const Sphere& sphere, double probe_A) { return {sphere.centre_A, sphere.radius_A + probe_A}; }

/// The circle in which the surfaces of two spheres meet; empty if they are apart, nested or concentric.
inline std::optional<SphereCircle> circleOf(const Sphere& a, const Sphere& b) {
  const Vec3 between = b.centre_A - a.centre_A;
  const double d = glm::length(between), R = a.radius_A, r = b.radius_A;
  if (!(d > 0.0) || !(d < R + r) || !(d > std::abs(R - r))) return std::nullopt;
  // Heron's formula; a difference of squares would lose half the digits of a small circle.
  const double factors = (R + r - d) * (R + r + d) * (d - R + r) * (d + R - r);
  if (!(factors > 0.0)) return std::nullopt;
  const Vec3 axis = between / d;
  return SphereCircle{a.centre_A + axis * ((d * d - r * r + R * R) / (2.0 * d)), axis, std::sqrt(factors) / (2.0 * d)};
}

/// The two points where the surfaces of three spheres meet; empty if there are none.
inline std::optional<std::array<Vec3, 2>> pointsOf(const Sphere& a, const Sphere& b, const Sphere& c) {
  const auto circle = circleOf(a, b);
  if (!circle) return std::nullopt;
  const Vec3 to_c = c.centre_A - circle->centre_A;
  const double along = glm::dot(to_c, circle->axis);
  const double cut = c.radius_A * c.radius_A - along * along;  // squared radius of c's section by the circle's plane
  const Vec3 v = to_c - along * circle->axis;
  const double d = glm::length(v);
  if (!(cut > 0) || !(d > 0)) return std::nullopt;
  const double x = (d * d - cut + circle->radius_A * circle->radius_A) / (2 * d);
  const double square = circle->radius_A * circle->radius_A - x * x;
  if (!(square > 0)) return std::nullopt;
  const Vec3 foot = circle->centre_A + v * (x / d), side = glm::cross(circle->axis, v / d) * std::sqrt(square);
  return std::array<Vec3, 2>{foot + side, foot - side};
}

/// A unit vector perpendicular to `axis` (of any length except 0).
inline Vec3 anyNormal(const Vec3& axis) {
  const Vec3 other = std::abs(axis.x) < 0.6 * glm::length(axis) ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
  return glm::normalize(glm::cross(axis, other));
}

}  // namespace moltact
