// The SCP on a surface that swells or shrinks: the probe's radius changes while touching. After each small change the
// SCP goes to the nearest free place, which lies on a sphere, a circle or a point of the few spheres that now hold it
// inside. So it does where rounding has let it sink. Part of ExactTracker; haptic thread.
#include <algorithm>
#include <array>
#include <cmath>

#include "engine/haptics/exact/exact_tracker.h"
#include "engine/haptics/exact/nearest_places.h"

namespace moltact {
namespace {

constexpr double kPiece_A = 0.05;  // the radius changes by no more at once, so that the SCP stays on its side of a wall
constexpr double kMinPiece_A = 1e-5;  // where not even so small a change leaves a free place, there is none
constexpr double kSqueezed_A =
    0.5;  // out of a closing crease the SCP moves faster than the surface, but never through a wall
constexpr std::size_t kMaxHolding = 8;

// A short list of spheres without allocation.
struct Spheres {
  std::array<std::int32_t, kMaxHolding> sphere{};
  std::size_t count = 0;
  bool more = false;  // there were more than fit
  void add(std::int32_t index) {
    const auto end = sphere.begin() + std::ptrdiff_t(count);
    if (std::find(sphere.begin(), end, index) != end) return;
    if (count < kMaxHolding)
      sphere[count++] = index;
    else
      more = true;
  }
};

}  // namespace

void ExactTracker::setProbe(double probe_A) noexcept {
  if (!std::isfinite(probe_A)) return;
  goal_A_ = std::clamp(probe_A, 0.0, kLargestProbe_A);
  if (!swells_) step_A_ = kPiece_A;
  swells_ = goal_A_ != near_.probe_A();
  if (!swells_) return;
  near_.resetWorkCount();
  swell();
  swelled_ = true;
}

// Carries the SCP on toward the goal, step by step, until it is there or as much has been looked at as a tick may cost.
void ExactTracker::swell() noexcept {
  const std::uint64_t most = near_.looked() + kMaxLooked;
  do {
    const double now = near_.probe_A();
    if (!armed_ || goal_A_ < now) {
      near_.setProbe(goal_A_);
      if (armed_) depenetrate();
    } else {
      // Among crowds a step is no longer than what is known round the SCP, so that the places it may go to are known
      // too.
      const double known = near_.each(scp_, kSqueezed_A, [](const NearSphere&) {}),
                   step = std::min(step_A_, std::max(0.25 * known, kMinPiece_A));
      near_.setProbe(std::min(goal_A_, now + step));
      const Freed freed = depenetrate();
      if (freed == Freed::Yes) {
        step_A_ = std::min(kPiece_A, 2.0 * step_A_);
      } else if (freed == Freed::TooMany && step > kMinPiece_A) {  // in a smaller step fewer close in on it
        near_.setProbe(now);
        step_A_ = std::max(kMinPiece_A, 0.25 * step);
      } else {  // the place closed over the SCP: there is no surface left to be held by
        reset();
      }
    }
    swells_ = near_.probe_A() != goal_A_;
  } while (swells_ && near_.looked() < most);
  lookAtHolders();
}

// Brings the SCP to the nearest free place; with nothing changed when there is none among the spheres that close in on
// it.
ExactTracker::Freed ExactTracker::depenetrate() noexcept {
  const Vec3 was = scp_;
  const double sunk_A = 4.0 * contactAt(was);
  forgetSurroundings();

  Spheres closing_in;
  // Adds the spheres that p is inside of; tells whether there are any.
  const auto inside = [&](const Vec3& p) {
    bool any = false;
    near_.each(p, 0.0, [&](const NearSphere& b) {
      const Vec3 m = p - b.centre;
      const double r = b.radius - sunk_A;
      if (r <= 0.0 || glm::dot(m, m) >= r * r) return;
      any = true;
      closing_in.add(b.index);
    });
    return any;
  };
  const double known = near_.each(was, kSqueezed_A, [](const NearSphere&) {});
  if (!inside(was)) {
    if (feature_ != Feature::Free) feature_ = Feature::Point;  // the next flow finds what it rests on
    return Freed::Yes;
  }

  for (int round = 0; round < 4; ++round) {
    const Spheres among = closing_in;
    double best2 = std::pow(std::min(kSqueezed_A, known), 2);
    bool found = false;
    const auto offer = [&](const Vec3& p, std::int32_t a, std::int32_t b, std::int32_t c) {
      const Vec3 moved = p - was;
      const double d2 = glm::dot(moved, moved);
      if (!(d2 < best2) || inside(p)) return;
      best2 = d2;
      scp_ = p;
      found = true;
      holdBy(a, b, c);
    };
    for (std::size_t a = 0; a < among.count; ++a) {
      const std::int32_t i = among.sphere[a];
      const NearSphere si = near_.sphere(i);
      const Vec3 out = was - si.centre;
      if (const double far = glm::length(out); far > 0.0) offer(si.centre + out * (si.radius / far), i, -1, -1);
      for (std::size_t b = a + 1; b < among.count; ++b) {
        const std::int32_t j = among.sphere[b];
        const NearSphere sj = near_.sphere(j);
        Vec3 p;
        if (nearestOnCircle(si, sj, was, p)) offer(p, i, j, -1);
        for (std::size_t c = b + 1; c < among.count; ++c) {
          const std::int32_t k = among.sphere[c];
          Vec3 two[2];
          if (!commonPoints(si, sj, near_.sphere(k), two)) continue;
          offer(two[0], i, j, k);
          offer(two[1], i, j, k);
        }
      }
    }
    if (found) {
      feature_ = Feature::Point;  // the next flow finds which of them hold it
      return Freed::Yes;
    }
    if (closing_in.count == among.count) break;
  }
  return closing_in.more ? Freed::TooMany : Freed::No;
}

}  // namespace moltact
