#include "engine/haptics/paper/intersection_point.h"

#include <cmath>

namespace moltact::paper {

std::optional<IntersectionPoints> intersectionPoints(const IntersectionCircle& circle, const Vec3& S2, double r) {
  const Vec3& n = circle.axis;
  const Vec3& C1 = circle.centre;
  const double R = circle.radius;

  // The circle in which the plane of the first circle cuts the third sphere: centre C2, squared radius r^2 - d^2.
  const double d = glm::dot(n, S2 - C1);
  if (!(std::abs(d) < r)) return std::nullopt;
  const Vec3 C2 = S2 - n * d;
  const double r2 = std::sqrt((r - d) * (r + d));

  // Equations 5 and 6, with equation 2 in the plane for x.
  const Vec3 V = C2 - C1;
  const double K = glm::length(V);
  if (!(K > 1e-12 * (R + r2))) return std::nullopt;
  const double x = circleHeight(R, r2, K);
  const double y2 = (R - x) * (R + x);
  if (!(y2 > 0.0)) return std::nullopt;
  const Vec3 V_unit = V / K;
  const Vec3 F_unit = glm::cross(n, V_unit);  // unit vectors, because x and y are lengths (printed: n x V)
  const Vec3 alpha = C1 + V_unit * x;
  const Vec3 Fy = F_unit * std::sqrt(y2);
  return IntersectionPoints{alpha + Fy, alpha - Fy};
}

const PointPlane* PointVolume::crossed(const Vec3& hip) const {
  const PointPlane* out = nullptr;
  double farthest = 0.0;
  for (const PointPlane& plane : planes) {
    const double past = -glm::dot(plane.normal, hip - P);
    if (past > farthest) {
      farthest = past;
      out = &plane;
    }
  }
  return out;
}

std::optional<PointVolume> pointVolume(const Vec3& P, const std::array<std::int32_t, 3>& atoms,
                                       const std::array<Vec3, 3>& centres) {
  PointVolume out;
  out.P = P;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t i = k, j = (k + 1) % 3, third = (k + 2) % 3;
    // Equation 7, N = T x n: T from any point of the circle's axis to P gives the same plane as T = P - C1.
    const Vec3 T = P - centres[i], axis = centres[j] - centres[i];
    Vec3 N = glm::cross(T, axis);
    const double size = glm::length(N);
    if (!(size > 1e-12 * glm::length(T) * glm::length(axis))) return std::nullopt;
    N /= size;
    // The paper does not give the sign of N: the volume is on the third sphere's side.
    const Vec3 inward = centres[third] - P;
    const double side = glm::dot(N, inward);
    if (!(std::abs(side) > 1e-12 * glm::length(inward))) return std::nullopt;
    out.planes[k] = {side > 0.0 ? N : -N, {atoms[i], atoms[j]}};
  }
  return out;
}

}  // namespace moltact::paper
