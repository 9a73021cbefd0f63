#include "engine/haptics/sweep.h"

#include <algorithm>
#include <cmath>

#include "engine/haptics/sphere_motion.h"

namespace moltact {
namespace {

// The part [t0, t1] of the path from `from` along `path` inside the box; false if there is none.
bool clip(const Vec3& from, const Vec3& path, const Vec3& low, const Vec3& high, double& t0, double& t1) {
  for (int k = 0; k < 3; ++k) {
    if (path[k] == 0.0) {
      if (from[k] < low[k] || from[k] > high[k]) return false;
      continue;
    }
    double a = (low[k] - from[k]) / path[k], b = (high[k] - from[k]) / path[k];
    if (a > b) std::swap(a, b);
    t0 = std::max(t0, a);
    t1 = std::min(t1, b);
  }
  return t0 <= t1;
}

}  // namespace

Hit sweep(const SphereGrid& scene, double probe_A, const Vec3& from, const Vec3& to) noexcept {
  return sweepFrom(scene, probe_A, Vec3(0.0), from, to, 0.0);
}

Hit sweepFrom(const SphereGrid& scene, double probe_A, const Vec3& origin, const Vec3& from, const Vec3& to,
              double contact_A, const SphereMotion* motion, double fraction) noexcept {
  constexpr double kSpare_A = 1e-6;  // margin of the search range, larger than rounding
  const Vec3 path = to - from;
  double t0 = 0.0, t1 = 1.0;
  const Vec3 margin(probe_A + kSpare_A);
  if (scene.size() == 0 || !clip(from, path, scene.low_A() - origin - margin, scene.high_A() - origin + margin, t0, t1))
    return {};
  const double whole = glm::length(path);
  if (!(whole > 0.0)) return {};
  const Vec3 along = path / whole;

  // Lengths are measured from the path's entry into the box, so that a distant start costs no precision.
  const Vec3 start = t0 > 0.0 ? from + path * t0 : from;
  const double length = (t1 - t0) * whole;
  FirstHit first(start, along, length, contact_A);
  // Piece by piece, so that only spheres near the path are examined; in one piece in a sparse scene, where there would
  // be more pieces than spheres.
  const double piece = length > scene.cell_A() * (1.0 + 0.125 * double(scene.size())) ? length : scene.cell_A();
  for (double a = 0.0; a <= length; a += piece) {
    const Vec3 p = start + along * a, q = start + along * std::min(a + piece, length);
    scene.visitNearBox(
        origin + glm::min(p, q), origin + glm::max(p, q), probe_A + kSpare_A,
        [&](const Vec3& centre, double radius) { return first.mayMeet(centre - origin, radius + probe_A + kSpare_A); },
        [&](std::uint32_t i, const Sphere& bound) {
          const Sphere b = motion ? (*motion)[i].at(fraction) : bound;
          first.look(static_cast<std::int32_t>(i), b.centre_A - origin, b.radius_A + probe_A);
        });
    if (piece == length || (first.sphere() >= 0 && first.at() <= a + piece)) break;
  }
  if (first.sphere() < 0) return {};
  return {first.sphere(), std::min(1.0, t0 + first.at() / whole)};
}

double distanceToBox(const SphereGrid& scene, double probe_A, const Vec3& place) noexcept {
  if (scene.size() == 0) return kMaxPosition_A;
  const Vec3 low = scene.low_A() - Vec3(probe_A), high = scene.high_A() + Vec3(probe_A);
  return glm::length(glm::max(glm::max(low - place, place - high), Vec3(0.0)));
}

double clearance(const SphereGrid& scene, double probe_A, const Vec3& place, const SphereMotion* motion,
                 double fraction) noexcept {
  const double workCount = 0.5 * scene.cell_A(), to_box = distanceToBox(scene, probe_A, place);
  if (to_box > workCount) return to_box;
  double best = workCount;
  scene.visitNear(place, probe_A + workCount, [&](std::uint32_t i, const Sphere& bound) {
    const Sphere b = motion ? (*motion)[i].at(fraction) : bound;
    reduceGap(best, place - b.centre_A, b.radius_A + probe_A);
  });
  return best;
}

}  // namespace moltact
