// The SCP on a surface that swells or shrinks: the probe's radius changes while touching. After each small change the
// SCP goes to the nearest free place, which lies on a sphere, a circle or a point of the few balls that now hold it
// inside. So it does where rounding has let it sink. Part of ExactTracker; haptic thread.
#include <algorithm>
#include <array>
#include <cmath>

#include "engine/haptics/exact/exact_tracker.h"
#include "engine/haptics/exact/nearest_places.h"

namespace moltact {
namespace {

constexpr double kPiece_A = 0.05;  // the radius changes by no more at once, so that the SCP stays on its side of a wall
constexpr double kSqueezed_A =
    0.5;  // out of a closing crease the SCP moves faster than the surface, but never through a wall
constexpr std::size_t kMostHolding = 8;

// A short list of balls without allocation.
struct Balls {
  std::array<std::int32_t, kMostHolding> ball{};
  std::size_t count = 0;
  void add(std::int32_t index) {
    const auto end = ball.begin() + std::ptrdiff_t(count);
    if (count < kMostHolding && std::find(ball.begin(), end, index) == end) ball[count++] = index;
  }
};

}  // namespace

void ExactTracker::setProbe(double probe_A) noexcept {
  if (!std::isfinite(probe_A)) return;
  const double wanted = std::clamp(probe_A, 0.0, kLargestProbe_A), had = near_.probe_A();
  if (wanted == had) return;
  const int pieces = !armed_ || wanted < had ? 1 : static_cast<int>(std::ceil((wanted - had) / kPiece_A));
  for (int k = 1; k <= pieces; ++k) {
    near_.setProbe(k == pieces ? wanted : had + (wanted - had) * k / pieces);
    if (!armed_) continue;
    if (!toFreePlace()) {  // the place closed over the SCP: there is no surface left to be held by
      near_.setProbe(wanted);
      reset();
      return;
    }
  }
}

// Brings the SCP to the nearest free place; false, with nothing changed, when there is none among the balls that close
// in on it.
bool ExactTracker::toFreePlace() noexcept {
  const Vec3 was = scp_;
  const double sunk_A = 4.0 * contactAt(was);
  forgetSurroundings();

  Balls closing_in;
  // Adds the balls that p is inside of; tells whether there are any.
  const auto inside = [&](const Vec3& p) {
    bool any = false;
    near_.each(p, 0.0, [&](const NearBall& b) {
      const Vec3 m = p - b.centre;
      const double r = b.radius - sunk_A;
      if (r <= 0.0 || glm::dot(m, m) >= r * r) return;
      any = true;
      closing_in.add(b.index);
    });
    return any;
  };
  if (!inside(was)) {
    if (feature_ != Feature::Free) feature_ = Feature::Point;  // the next flow finds what it rests on
    return true;
  }

  for (int round = 0; round < 4; ++round) {
    const Balls among = closing_in;
    double best2 = kSqueezed_A * kSqueezed_A;
    bool found = false;
    const auto offer = [&](const Vec3& p, std::int32_t a, std::int32_t b, std::int32_t c) {
      const Vec3 way = p - was;
      const double d2 = glm::dot(way, way);
      if (!(d2 < best2) || inside(p)) return;
      best2 = d2;
      scp_ = p;
      found = true;
      holdBy(a, b, c);
    };
    for (std::size_t a = 0; a < among.count; ++a) {
      const std::int32_t i = among.ball[a];
      const NearBall si = near_.ball(i);
      const Vec3 out = was - si.centre;
      if (const double far = glm::length(out); far > 0.0) offer(si.centre + out * (si.radius / far), i, -1, -1);
      for (std::size_t b = a + 1; b < among.count; ++b) {
        const std::int32_t j = among.ball[b];
        const NearBall sj = near_.ball(j);
        Vec3 p;
        if (nearestOnCircle(si, sj, was, p)) offer(p, i, j, -1);
        for (std::size_t c = b + 1; c < among.count; ++c) {
          const std::int32_t k = among.ball[c];
          Vec3 two[2];
          if (!commonPoints(si, sj, near_.ball(k), two)) continue;
          offer(two[0], i, j, k);
          offer(two[1], i, j, k);
        }
      }
    }
    if (found) {
      feature_ = Feature::Point;  // the next flow finds which of them hold it
      return true;
    }
    if (closing_in.count == among.count) break;
  }
  return false;
}

}  // namespace moltact
