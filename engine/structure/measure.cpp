#include "engine/structure/measure.h"

#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

#include "engine/language/quantity_text.h"

namespace moltact {
namespace {

constexpr double kDegree = 180.0 / std::numbers::pi;

}  // namespace

double angle_deg(const PointA& a, const PointA& b, const PointA& c) {
  const Vec3 u = a.A - b.A, v = c.A - b.A;
  // Precise also for nearly flat angles, unlike the arc cosine.
  return kDegree * std::atan2(glm::length(glm::cross(u, v)), glm::dot(u, v));
}

double torsion_deg(const PointA& a, const PointA& b, const PointA& c, const PointA& d) {
  const Vec3 u = b.A - a.A, v = c.A - b.A, w = d.A - c.A;
  const Vec3 n = glm::cross(u, v), m = glm::cross(v, w);
  return kDegree * std::atan2(glm::dot(u, m) * glm::length(v), glm::dot(n, m));
}

std::string measureText(std::span<const PointA> places) {
  switch (places.size()) {
    case 2:
      return quantityText(glm::distance(places[0].A, places[1].A), Dimension::Length, decimals(2));
    case 3:
      return quantityText(angle_deg(places[0], places[1], places[2]), Dimension::Angle, decimals(1));
    case 4:
      return quantityText(torsion_deg(places[0], places[1], places[2], places[3]), Dimension::Angle, decimals(1));
    default:
      return {};
  }
}

}  // namespace moltact
