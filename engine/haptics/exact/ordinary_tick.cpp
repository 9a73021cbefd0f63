// The ticks that are most: the SCP stays on its feature, and what is known of the surroundings says that nothing is in
// the way. Part of ExactTracker; haptic thread. Units: angstrom; radian.
#include <cmath>

#include "engine/haptics/exact/entry_angle.h"
#include "engine/haptics/exact/exact_tracker.h"

namespace moltact {
namespace {

constexpr double kArcOfChord2 =
    2.4674011002723397;  // an arc of up to half a turn is at most pi / 2 times as long as its chord

}  // namespace

// Leads the SCP to the place on its feature nearest to the HIP; false, with nothing changed, where that may not be all.
bool ExactTracker::holdsQuickly(const Vec3& hip) noexcept {
  switch (feature_) {
    case Feature::Free:
      return false;  // step() has looked
    case Feature::Sphere: {
      const NearBall ball = near_.ball(holders_[0]);
      const Vec3 m = hip - ball.centre;
      const double r = ball.radius, d2 = glm::dot(m, m);
      if (d2 >= r * r || d2 < r * r * 1e-6) return false;
      const double d = std::sqrt(d2), along = glm::dot(m, patch_.centre);
      if (along < patch_.clear * d) {
        if (along < patch_.cosine * d) return false;
        // From the last place to the nearest cap's rim and on to this one is a longer way than from the one to the
        // other.
        const Vec3 x = (scp_ - ball.centre) / r, y = m / d, chord = y - x;
        const double gap = patch_.rim - glm::dot(y, patch_.axis), room = patch_.rim - glm::dot(x, patch_.axis) + gap;
        if (gap <= 0.0 || room * room <= kArcOfChord2 * glm::dot(chord, chord)) return false;
      }
      scp_ = ball.centre + m * (r / d);
      return true;
    }
    case Feature::Circle: {
      const Circle& c = circle_;
      if (c.i < 0) return false;
      const Vec3 m = hip - c.centre;
      const double along = glm::dot(m, c.axis), y1 = glm::dot(m, c.axis_1), y2 = glm::dot(m, c.axis_2);
      const double out = std::sqrt(y1 * y1 + y2 * y2);
      if (out < 1e-6 * c.radius) return false;
      // Both balls must hold the SCP from the start of the way to its end: shares mu_i, mu_j >= 0
      // (docs/exact-tracker.md).
      const double start = 1.0 - (y1 * c.along_1 + y2 * c.along_2) / c.radius, end = 1.0 - out / c.radius;
      const double slack_i = std::min(start * c.to_j, end * c.to_j) - along,
                   slack_j = std::min(start * c.to_i, end * c.to_i) + along;
      if (slack_i < 0.0 || slack_j < 0.0) return false;
      if (c.narrow) {  // between two ends less than half a turn apart the short way stays between them
        if (c.low_1 * y2 - c.low_2 * y1 <= 0.0 || y1 * c.high_2 - y2 * c.high_1 <= 0.0) return false;
      } else {
        double angle = std::atan2(y2, y1);
        angle += kTwoPi * std::round((c.angle - angle) / kTwoPi);  // the short way round
        if (angle <= c.low || angle >= c.high) return false;
        circle_.angle = angle;
      }
      circle_.along_1 = y1 / out;
      circle_.along_2 = y2 / out;
      scp_ = c.centre + (c.axis_1 * y1 + c.axis_2 * y2) * (c.radius / out);
      return true;
    }
    case Feature::Point: {
      if (!holds_known_) return false;
      const Vec3 displacement = hip - scp_;
      return glm::dot(holds_[0], displacement) <= 0.0 && glm::dot(holds_[1], displacement) <= 0.0 &&
             glm::dot(holds_[2], displacement) <= 0.0;
    }
  }
  return false;
}

}  // namespace moltact
