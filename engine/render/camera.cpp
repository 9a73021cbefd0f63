#include "engine/render/camera.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "engine/molecule/molecule.h"

namespace moltact {
namespace {
constexpr double kNearest_A = 0.5, kMaxBack_A = 1e7;

// The axis of largest spread, by power iteration; any direction if the spread is isotropic.
Vec3 longestAxis(const glm::dmat3& spread) {
  Vec3 axis = glm::normalize(Vec3(0.36, 0.48, 0.8));
  for (int k = 0; k < 200; ++k) {
    const Vec3 next = spread * axis;
    if (!(glm::length(next) > 0.0)) break;
    axis = glm::normalize(next);
  }
  return axis;
}

// The covariance of points about their mean.
glm::dmat3 spreadOf(std::span<const Vec3> places_A) {
  Vec3 middle(0.0);
  for (const Vec3& p : places_A) middle += p / double(places_A.size());
  glm::dmat3 spread(0.0);
  for (const Vec3& p : places_A) spread += glm::outerProduct(p - middle, p - middle);
  return spread;
}

// The spread without its component along a known axis.
glm::dmat3 withoutAxis(const glm::dmat3& spread, const Vec3& axis) {
  return spread - glm::dot(axis, spread * axis) * glm::outerProduct(axis, axis);
}
}  // namespace

Vec3 Camera::toView(PointA place) const {
  return glm::conjugate(orientation) * (place.A - target.A) - Vec3(0, 0, distance_A);
}

PointA Camera::fromView(const Vec3& view) const { return {target.A + orientation * (view + Vec3(0, 0, distance_A))}; }

double Camera::tanHalfY() const { return std::tan(0.5 * fov_y_rad); }

Ray Camera::rayThrough(double x_px, double y_px, int width_px, int height_px) const {
  const double x = 2.0 * x_px / width_px - 1.0, y = 1.0 - 2.0 * y_px / height_px;
  const Vec3 view(x * tanHalfX(width_px, height_px), y * tanHalfY(), -1.0);
  return {eye(), glm::normalize(orientation * view)};
}

Vec3 Camera::project(PointA place, int width_px, int height_px) const {
  const Vec3 v = toView(place);
  const double depth = -v.z;
  return {(1.0 + v.x / depth / tanHalfX(width_px, height_px)) * 0.5 * width_px,
          (1.0 - v.y / depth / tanHalfY()) * 0.5 * height_px, depth};
}

void Camera::orbit(double right_rad, double down_rad) {
  const glm::dquat turn = glm::angleAxis(-right_rad, Vec3(0, 1, 0)) * glm::angleAxis(-down_rad, Vec3(1, 0, 0));
  orientation = glm::normalize(orientation * turn);
}

void Camera::roll(double angle_rad) {
  orientation = glm::normalize(orientation * glm::angleAxis(-angle_rad, Vec3(0, 0, 1)));
}

void Camera::zoom(double factor) {
  if (!(factor > 0) || !std::isfinite(factor)) return;
  distance_A = std::clamp(distance_A / factor, kNearest_A, kMaxBack_A);
}

void Camera::pan(double dx_px, double dy_px, int height_px) {
  const double A = pixel_A(distance_A, height_px);
  target.A += (up() * dy_px - right() * dx_px) * A;
}

void Camera::lookFrom(double azimuth_rad, double elevation_rad) {
  orientation = glm::angleAxis(azimuth_rad, Vec3(0, 1, 0)) * glm::angleAxis(-elevation_rad, Vec3(1, 0, 0));
}

void Camera::lookSideOn(const Molecule& molecule) {
  constexpr double kLong = 1.3;   // minimum ratio of the spread along the longest axis to that across it
  constexpr double kEndOn = 0.7;  // minimum cosine between the axis and the direction to the eye
  if (molecule.atoms.size() < 2) return;
  std::vector<Vec3> places_A;
  for (const Sphere& a : molecule.spheres) places_A.push_back(a.centre_A);
  const glm::dmat3 spread = spreadOf(places_A);
  const Vec3 axis = longestAxis(spread);
  const double along = glm::dot(axis, spread * axis);
  const glm::dmat3 rest = withoutAxis(spread, axis);
  const Vec3 second = longestAxis(rest);
  if (along < kLong * kLong * glm::dot(second, rest * second)) return;
  Vec3 seen = glm::conjugate(orientation) * axis;
  if (std::abs(seen.z) < kEndOn) return;
  if (seen.z < 0.0) seen = -seen;
  const Vec3 to(1, 0, 0);
  const glm::dquat turn = glm::normalize(glm::dquat(1.0 + glm::dot(seen, to), glm::cross(seen, to)));
  orientation = glm::normalize(orientation * glm::conjugate(turn));
}

void Camera::lookAlongThinnest(std::span<const Vec3> places_A) {
  if (places_A.size() < 3) return;
  const glm::dmat3 spread = spreadOf(places_A);
  const Vec3 longest = longestAxis(spread);
  Vec3 thinnest = glm::cross(longest, longestAxis(withoutAxis(spread, longest)));
  if (!(glm::length(thinnest) > 1e-6)) return;
  thinnest = glm::normalize(thinnest);
  const Vec3 size = glm::abs(thinnest);
  const double largest = size.z >= size.x && size.z >= size.y ? thinnest.z : size.y >= size.x ? thinnest.y : thinnest.x;
  if (largest < 0.0) thinnest = -thinnest;
  lookFrom(std::atan2(thinnest.x, thinnest.z), std::asin(std::clamp(thinnest.y, -1.0, 1.0)));
}

void Camera::face(PointA place) {
  constexpr double kSamePlace_A = 0.1;
  const Vec3 offset = place.A - target.A;
  if (glm::length(offset) > kSamePlace_A)
    lookFrom(std::atan2(offset.x, offset.z), std::atan2(offset.y, std::hypot(offset.x, offset.z)));
}

void Camera::fit(const Molecule& molecule, double aspect, double margin, double grown_A,
                 std::span<const std::uint32_t> without) {
  if (molecule.atoms.empty()) return;
  if (without.size() >= molecule.atoms.size()) without = {};
  // In the camera's axes, relative to the first atom; m is the target's x. A sphere of radius r at (x, z) stays below
  // the plane through the eye with slope t if distance >= z + (x - m + r sqrt(1 + t^2)) / t. The optimal m equalizes
  // the largest bounds of the two sides, so that the perspective picture is filled from edge to edge.
  const glm::dquat to_axes = glm::conjugate(orientation);
  const Vec3 origin = molecule.spheres[0].centre_A;
  const double slope[2] = {tanHalfY() * aspect * (1 - margin), tanHalfY() * (1 - margin)};
  double ahead[2] = {-1e300, -1e300}, behind[2] = {-1e300, -1e300}, low = 1e300, high = -1e300;
  for (std::size_t i = 0, left_out = 0; i < molecule.atoms.size(); ++i) {
    if (left_out < without.size() && without[left_out] == i) {
      ++left_out;
      continue;
    }
    const Vec3 p = to_axes * (molecule.spheres[i].centre_A - origin);
    const double radius = molecule.spheres[i].radius_A + grown_A;
    low = std::min(low, p.z - radius);
    high = std::max(high, p.z + radius);
    const double across[2] = {p.x, p.y};
    for (std::size_t k = 0; k < 2; ++k) {
      const double widened = radius * std::sqrt(1 + slope[k] * slope[k]);
      ahead[k] = std::max(ahead[k], p.z + (across[k] + widened) / slope[k]);
      behind[k] = std::max(behind[k], p.z + (widened - across[k]) / slope[k]);
    }
  }
  const Vec3 middle(0.5 * slope[0] * (ahead[0] - behind[0]), 0.5 * slope[1] * (ahead[1] - behind[1]),
                    0.5 * (low + high));
  const double back = 0.5 * std::max(ahead[0] + behind[0], ahead[1] + behind[1]) - middle.z;
  target.A = origin + orientation * middle;
  distance_A = std::clamp(back, kNearest_A, kMaxBack_A);
}

void Camera::fit(PointA centre, double radius_A, double aspect, double margin) {
  const double t = tanHalfY() * std::min(1.0, aspect) * (1 - margin);
  target = centre;
  distance_A = std::clamp(radius_A * std::sqrt(1 + t * t) / t, kNearest_A, kMaxBack_A);
}

}  // namespace moltact
