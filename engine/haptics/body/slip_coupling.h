// The rotational coupling of a body to the hand. Beyond an angle it slips by the excess, as a friction clutch does, so that
// the torque does not change its sign at half a turn. Haptic thread. Units: angstrom, radian.
#pragma once

#include "engine/core/units.h"

namespace moltact {

class SlipCoupling {
 public:
  static constexpr double kSlip_rad = 2.0;  ///< the coupling slips beyond this angle

  void reset() noexcept { slip_ = kNoRotation; }
  /// Starts at this hand without a slip.
  void begin(const PoseA& hand) noexcept {
    slip_ = kNoRotation;
    last_hand_ = hand;
  }

  /// The orientation to which the spring turns a body that has the orientation `body`. While the body is `free`, the slip
  /// is undone in proportion to the motion of the hand; `lever_A` (above 0) converts a rotation to a length.
  Quat orientation(const PoseA& hand, const Quat& body, bool free, double lever_A) noexcept {
    if (free && slip_ != kNoRotation) {
      const Vec3 angle = rotationBetween(kNoRotation, slip_);
      const double slipped = glm::length(angle),
                   moved = glm::distance(hand.place.A, last_hand_.place.A) / lever_A +
                           glm::length(rotationBetween(last_hand_.orientation, hand.orientation));
      slip_ = moved >= slipped ? kNoRotation : glm::angleAxis(slipped - moved, angle / slipped);
    }
    last_hand_ = hand;
    const Quat coupled = glm::normalize(slip_ == kNoRotation ? hand.orientation : hand.orientation * slip_);
    if (free) return coupled;
    const Vec3 theta = rotationBetween(body, coupled);
    const double angle = glm::length(theta);
    if (angle <= kSlip_rad) return coupled;
    const Quat held = glm::normalize(glm::angleAxis(kSlip_rad, theta / angle) * body);
    slip_ = glm::normalize(glm::conjugate(hand.orientation) * held);
    return held;
  }

 private:
  Quat slip_ = kNoRotation;  // the coupling's orientation is the hand's times this
  PoseA last_hand_;
};

}  // namespace moltact
