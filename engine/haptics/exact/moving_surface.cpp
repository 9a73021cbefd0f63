// The SCP on a surface that grows or shrinks because the probe changes during contact. After each small change the SCP
// moves to the nearest free point, which lies on a sphere, a circle or a point of the few spheres that contain it. The
// same correction applies where rounding made it penetrate. Part of ExactTracker; haptic thread.
#include <algorithm>
#include <array>
#include <cmath>

#include "engine/haptics/exact/exact_tracker.h"
#include "engine/haptics/exact/nearest_places.h"

namespace moltact {
namespace {

constexpr double kPiece_A = 0.05;  // largest change of the radius per step, so that the SCP stays on its side of a wall
constexpr double kMinPiece_A = 1e-5;  // if even a change this small leaves no free point, there is none
constexpr double kSqueezed_A =
    0.5;  // search radius: the SCP moves out of a closing crease faster than the surface, but not through a wall
constexpr std::size_t kMaxHolding = 8;

// A short list of spheres without allocation.
struct Spheres {
  std::array<std::int32_t, kMaxHolding> sphere{};
  std::size_t count = 0;
  bool more = false;  // the capacity was exceeded
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
  goal_A_ = std::clamp(probe_A, 0.0, kMaxProbe_A);
  if (!resizing_) step_A_ = kPiece_A;
  resizing_ = goal_A_ != near_.probe_A();
  if (!resizing_) return;
  near_.resetWorkCount();
  resizeProbe();
  resized_ = true;
}

// Moves the SCP step by step toward the new radius, until it is reached or the work limit of a tick is exhausted.
void ExactTracker::resizeProbe() noexcept {
  const std::uint64_t limit = near_.workCount() + kMaxWork;
  do {
    const double now = near_.probe_A();
    if (!armed_ || goal_A_ < now) {
      near_.setProbe(goal_A_);
      if (armed_) depenetrate();
    } else {
      // In crowded regions a step is limited to the known range around the SCP, so that the possible target points are
      // known too.
      const double known = near_.each(scp_, kSqueezed_A, [](const NearSphere&) {}),
                   step = std::min(step_A_, std::max(0.25 * known, kMinPiece_A));
      near_.setProbe(std::min(goal_A_, now + step));
      const Freed freed = depenetrate();
      if (freed == Freed::Yes) {
        step_A_ = std::min(kPiece_A, 2.0 * step_A_);
      } else if (freed == Freed::TooMany && step > kMinPiece_A) {  // a smaller step involves fewer spheres
        near_.setProbe(now);
        step_A_ = std::max(kMinPiece_A, 0.25 * step);
      } else {  // the surroundings have closed over the SCP: no surface is left
        reset();
      }
    }
    resizing_ = near_.probe_A() != goal_A_;
  } while (resizing_ && near_.workCount() < limit);
  cacheActiveSet();
}

// Moves the SCP to the nearest free point. Changes nothing if the spheres that contain it leave none.
ExactTracker::Freed ExactTracker::depenetrate() noexcept {
  const Vec3 was = scp_;
  const double sunk_A = 4.0 * contactAt(was);
  forgetSurroundings();

  Spheres closing_in;
  // Adds the spheres that contain p; returns true if there are any.
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
    if (feature_ != Feature::Free) feature_ = Feature::Point;  // the next step determines the active set
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
      feature_ = Feature::Point;  // the next step determines the active set
      return Freed::Yes;
    }
    if (closing_in.count == among.count) break;
  }
  return closing_in.more ? Freed::TooMany : Freed::No;
}

}  // namespace moltact
