// The SCP among moving spheres (sphere_motion.h). Each tick moves the listed spheres. If nothing can have come between,
// the SCP is then computed directly on its feature. Otherwise it is moved out of the approaching spheres in small
// steps, and the full tick follows. Part of ExactTracker; haptic thread.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "engine/haptics/exact/exact_tracker.h"
#include "engine/haptics/exact/nearest_places.h"

namespace moltact {
namespace {

constexpr double kPiece_A =
    0.05;  // largest motion of the surface per step, so that the SCP stays on its side of a wall
constexpr double kMaxMoves = 64.0;      // largest number of steps per tick; faster motions use larger steps
constexpr double kArcOfChord = 1.5708;  // an arc of up to half a turn is at most pi / 2 times as long as its chord

}  // namespace

bool ExactTracker::setMotion(const SphereMotion* motion) noexcept {
  if (near_.has(motion)) return true;
  // The SCP stays where it is; the next tick determines what it touches there.
  near_.setMotion(motion);
  forgetSurroundings();
  seen_fraction_ = clear_gap_ = 0.0;
  moved_ = true;
  return true;
}

void ExactTracker::advanceTo(double fraction) noexcept {
  if (fraction == near_.fraction() || !std::isfinite(fraction)) return;
  near_.advanceTo(std::clamp(fraction, 0.0, 1.0));
  forgetSurroundings();
  moved_ = true;
}

// Moves the SCP with the surface. If its new position for this HIP is certain, sets moved_ to false; otherwise the full
// tick follows.
void ExactTracker::trackSurface(const Vec3& hip) noexcept {
  const double fraction = near_.fraction(), from = std::exchange(seen_fraction_, fraction);
  if (!armed_) return;
  if (!near_.covers(scp_, 0.0)) near_.each(scp_, 0.0, [](const NearSphere&) {});
  const double moved_A = std::abs(fraction - from) * near_.maxMotion_A();
  if (moved_A <= kPiece_A && followsQuickly(hip, moved_A)) {
    moved_ = false;
    return;
  }
  clear_gap_ = 0.0;
  const int pieces = moved_A > kPiece_A ? int(std::ceil(std::min(moved_A / kPiece_A, kMaxMoves))) : 1;
  for (int k = 1; k <= pieces; ++k) {
    if (pieces > 1) near_.advanceTo(k == pieces ? fraction : from + (fraction - from) * k / pieces);
    if (depenetrate() == Freed::Yes) continue;
    near_.advanceTo(fraction);  // the surroundings have closed over the SCP: no surface is left
    reset();
    return;
  }
}

// True if the SCP stays on its feature and nothing else comes near; it is then the feature's point nearest to the HIP.
// `moved_A`: upper bound of the motion of any surface.
bool ExactTracker::followsQuickly(const Vec3& hip, double moved_A) noexcept {
  Vec3 place;
  switch (feature_) {
    case Feature::Free:
      return false;
    case Feature::Sphere: {
      const NearSphere on = near_.sphere(holders_[0]);
      const Vec3 m = hip - on.centre;
      const double d2 = glm::dot(m, m);
      if (d2 >= on.radius * on.radius || d2 < on.radius * on.radius * 1e-6) return false;
      place = on.centre + m * (on.radius / std::sqrt(d2));
      break;
    }
    case Feature::Circle: {
      const NearSphere i = near_.sphere(holders_[0]), j = near_.sphere(holders_[1]);
      if (!nearestOnCircle(i, j, hip, place)) return false;
      // Both block: the displacement is a sum of their inward normals with positive multipliers.
      const Vec3 n = (place - i.centre) / i.radius, m = (place - j.centre) / j.radius, d = place - hip;
      const double c = glm::dot(n, m), a = glm::dot(d, n), b = glm::dot(d, m);
      if (!(1.0 - c * c > 1e-6) || !(a > c * b) || !(b > c * a)) return false;
      break;
    }
    case Feature::Point: {
      if (holders_[2] < 0) return false;
      const std::array<NearSphere, 3> b{near_.sphere(holders_[0]), near_.sphere(holders_[1]),
                                        near_.sphere(holders_[2])};
      Vec3 two[2];
      if (!commonPoints(b[0], b[1], b[2], two)) return false;
      place = glm::distance(scp_, two[0]) < glm::distance(scp_, two[1]) ? two[0] : two[1];
      const Vec3 d = place - hip, n0 = (place - b[0].centre) / b[0].radius, n1 = (place - b[1].centre) / b[1].radius,
                 n2 = (place - b[2].centre) / b[2].radius;
      const Vec3 n12 = glm::cross(n1, n2);
      const double volume = glm::dot(n0, n12);
      if (!(std::abs(volume) > 1e-6)) return false;
      if (glm::dot(d, n12) * volume < 0.0 || glm::dot(d, glm::cross(n2, n0)) * volume < 0.0 ||
          glm::dot(d, glm::cross(n0, n1)) * volume < 0.0)
        return false;
      break;
    }
  }
  // Every other sphere must be farther away than this point plus the sphere's own motion.
  const double distance_A = kArcOfChord * (glm::distance(scp_, place) + moved_A) + moved_A;
  const auto clear = [&] {
    const double come_A = std::abs(near_.fraction() - clear_fraction_) * near_.maxMotion_A();
    return near_.covers(scp_, distance_A) && clear_gap_ > distance_A + come_A + glm::distance(scp_, clear_from_);
  };
  if (!clear()) {
    clear_from_ = scp_;
    clear_fraction_ = near_.fraction();
    clear_gap_ = kMaxPosition_A;
    const double known = near_.each(scp_, distance_A, [&](const NearSphere& b) {
      if (b.index != holders_[0] && b.index != holders_[1] && b.index != holders_[2])
        reduceGap(clear_gap_, scp_ - b.centre, b.radius);
    });
    clear_gap_ = std::min(clear_gap_, known);
    if (!clear()) return false;
  }
  scp_ = place;
  cacheActiveSet();
  return true;
}

}  // namespace moltact
