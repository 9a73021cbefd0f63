#include "molecules/generator/internal_coordinates.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace moltact::generator {

double radians(double deg) { return deg * std::numbers::pi / 180; }

Vec3 placeAtom(Vec3 a, Vec3 b, Vec3 c, double length_A, double angle_deg, double torsion_deg) {
  const double angle = radians(angle_deg), torsion = radians(torsion_deg);
  const Vec3 bc = glm::normalize(c - b);
  const Vec3 n = glm::normalize(glm::cross(b - a, bc));
  const Vec3 m = glm::cross(n, bc);
  return c + length_A * (-std::cos(angle) * bc + std::sin(angle) * (std::cos(torsion) * m + std::sin(torsion) * n));
}

}  // namespace moltact::generator
