#include "engine/haptics/sweep.h"

#include <algorithm>
#include <cmath>

namespace moltact {
namespace {

// The part [t0, t1] of the way from `from` along `way` that lies in the box; false when none does.
bool clip(const Vec3& from, const Vec3& way, const Vec3& low, const Vec3& high, double& t0, double& t1) {
  for (int k = 0; k < 3; ++k) {
    if (way[k] == 0.0) {
      if (from[k] < low[k] || from[k] > high[k]) return false;
      continue;
    }
    double a = (low[k] - from[k]) / way[k], b = (high[k] - from[k]) / way[k];
    if (a > b) std::swap(a, b);
    t0 = std::max(t0, a);
    t1 = std::min(t1, b);
  }
  return t0 <= t1;
}

}  // namespace

Hit sweep(const BallScene& scene, double probe_A, const Vec3& from, const Vec3& to,
          std::span<const std::int32_t> leaving) noexcept {
  const Vec3 way = to - from;
  double t0 = 0.0, t1 = 1.0;
  if (scene.size() == 0 || !clip(from, way, scene.low_A() - Vec3(probe_A), scene.high_A() + Vec3(probe_A), t0, t1)) return {};
  const double whole = glm::length(way);
  if (!(whole > 0.0)) return {};
  const Vec3 along = way / whole;

  // Lengths are counted from where the way enters the box: a start a million angstroms off costs no digits.
  const Vec3 start = t0 > 0.0 ? from + way * t0 : from;
  const double length = (t1 - t0) * whole;
  double best = length;
  std::int32_t ball = -1;
  // Piece by piece, so that only balls near the way are looked at; in a sparse scene, where that would be more pieces
  // than balls, all at once.
  const double piece = length > scene.cell_A() * (1.0 + 0.125 * double(scene.size())) ? length : scene.cell_A();
  for (double a = 0.0; a <= length; a += piece) {
    const Vec3 p = start + along * a, q = start + along * std::min(a + piece, length);
    scene.visitNearBox(glm::min(p, q), glm::max(p, q), probe_A, [&](std::uint32_t i, const Ball& b) {
      const Vec3 m = start - b.centre_A;
      const double nearest = -glm::dot(m, along);  // where the way comes nearest to the centre
      if (nearest <= 0.0) return;                  // it leads away from this ball
      const Vec3 off = m + along * nearest;
      const double r = b.radius_A + probe_A, gap2 = r * r - glm::dot(off, off);
      if (gap2 <= 0.0) return;
      const double enters = std::max(0.0, nearest - std::sqrt(gap2));
      if (enters > best || (enters == best && ball >= 0)) return;
      if (std::find(leaving.begin(), leaving.end(), static_cast<std::int32_t>(i)) != leaving.end()) return;
      best = enters;
      ball = static_cast<std::int32_t>(i);
    });
    if (piece == length || (ball >= 0 && best <= a + piece)) break;
  }
  if (ball < 0) return {};
  return {ball, std::min(1.0, t0 + best / whole)};
}

double clearance(const BallScene& scene, double probe_A, const Vec3& place) noexcept {
  const Vec3 low = scene.low_A() - Vec3(probe_A), high = scene.high_A() + Vec3(probe_A);
  if (scene.size() == 0) return kFarthest_A;
  const double looked = 0.5 * scene.cell_A();
  const Vec3 outside = glm::max(glm::max(low - place, place - high), Vec3(0.0));
  const double to_box = glm::length(outside);
  if (to_box > looked) return to_box;
  double best = looked;
  scene.visitNear(place, probe_A + looked, [&](std::uint32_t, const Ball& b) {
    const Vec3 m = place - b.centre_A;
    const double d2 = glm::dot(m, m), r = b.radius_A + probe_A, reach = best + r;
    if (reach > 0.0 && d2 < reach * reach) best = std::sqrt(d2) - r;
  });
  return best;
}

}  // namespace moltact
