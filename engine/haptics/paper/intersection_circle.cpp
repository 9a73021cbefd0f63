#include "engine/haptics/paper/intersection_circle.h"

#include <cmath>

namespace moltact::paper {

double circleHeight(double R, double r, double d) { return (d * d - r * r + R * R) / (2.0 * d); }

std::optional<IntersectionCircle> intersectionCircle(const Vec3& S0, double R, const Vec3& S1, double r) {
  const Vec3 S = S1 - S0;
  const double d = glm::length(S);
  if (!(d > 0.0) || !(d < R + r) || !(d > std::abs(R - r))) return std::nullopt;
  IntersectionCircle circle;
  circle.axis = S / d;
  circle.height = circleHeight(R, r, d);
  // Equation 3 in factors (Heron's formula); the printed difference of squares loses half the digits of a small circle.
  const double factors = (R + r - d) * (R + r + d) * (d - R + r) * (d + R - r);
  if (!(factors > 0.0)) return std::nullopt;
  circle.radius = std::sqrt(factors) / (2.0 * d);
  // Equation 4 from S0, the sphere from which x is measured (printed: S1).
  circle.centre = S0 + circle.axis * circle.height;
  return circle;
}

Vec3 closestOnCircle(const IntersectionCircle& circle, const Vec3& hip, const Vec3& last) {
  const auto inPlane = [&](const Vec3& p) { return p - circle.axis * glm::dot(p, circle.axis); };
  const auto usable = [&](const Vec3& p) { return glm::dot(p, p) > 1e-24 * circle.radius * circle.radius; };
  Vec3 out = inPlane(hip - circle.centre);
  if (!usable(out)) out = inPlane(last - circle.centre);
  if (!usable(out)) out = inPlane(std::abs(circle.axis.x) < 0.6 ? Vec3(1, 0, 0) : Vec3(0, 1, 0));
  return circle.centre + out * (circle.radius / glm::length(out));
}

}  // namespace moltact::paper
