#include "engine/device/scripted_hand.h"

#include <algorithm>
#include <cmath>

#include "engine/core/even_directions.h"

namespace moltact {
namespace {

constexpr int kVisits = 13;  // number of sides before the sequence repeats
constexpr double kSlide_rad_per_s = 0.25;
constexpr double kTurn_rad_per_s = 3.0;
constexpr double kYield_mm_per_s_N = 15.0;  // speed at which the hand yields to the felt force

}  // namespace

// The sides lie on a spiral over the hemisphere that faces the user.
Vec3 ScriptedHand::sideOf(int visit) noexcept {
  const double z = 1.0 - 0.8 * visit / kVisits, flat = std::sqrt(1.0 - z * z), turn = kGoldenAngle_rad * visit;
  return {flat * std::cos(turn), flat * std::sin(turn), z};
}

ScriptedHand::ScriptedHand() : side_(sideOf(0)) { approach(); }

void ScriptedHand::approach() noexcept {
  along_ = glm::normalize(glm::cross(side_, std::abs(side_.y) < 0.9 ? Vec3(0, 1, 0) : Vec3(1, 0, 0)));
  doing_ = Doing::Approaches;
  slid_s_ = 0;
}

PointMm ScriptedHand::lead(double dt_s, ForceN felt) noexcept {
  const double push_N = std::max(0.0, glm::dot(felt.N, side_));
  switch (doing_) {
    case Doing::Approaches:
      distance_mm_ -= kApproach_mm_per_s * dt_s;
      if (push_N > 0.3 * kPress_N || distance_mm_ < 1.0) doing_ = Doing::Slides;
      break;
    case Doing::Slides: {
      distance_mm_ = std::clamp(distance_mm_ + (push_N - kPress_N) * kYield_mm_per_s_N * dt_s, 1.0, kAway_mm);
      // If the probe is caught the hand waits, like a person's hand.
      const double across_N = glm::length(felt.N - side_ * glm::dot(felt.N, side_));
      const double turn = kSlide_rad_per_s * dt_s * std::clamp(1.5 - across_N / kPress_N, 0.0, 1.0);
      const Vec3 side = glm::normalize(side_ + along_ * turn);
      along_ = glm::normalize(along_ - side * glm::dot(along_, side));
      side_ = side;
      if ((slid_s_ += dt_s) > kSlide_s) doing_ = Doing::Leaves;
      break;
    }
    case Doing::Leaves:
      distance_mm_ = std::min(kAway_mm, distance_mm_ + 2 * kApproach_mm_per_s * dt_s);
      if (distance_mm_ < kAway_mm) break;
      visit_ = (visit_ + 1) % kVisits;
      doing_ = Doing::Turns;
      break;
    case Doing::Turns: {  // around the outside
      const Vec3 motion = sideOf(visit_) - side_;
      const double left = glm::length(motion), step = kTurn_rad_per_s * dt_s;
      side_ = glm::normalize(left <= step ? sideOf(visit_) : side_ + motion * (step / left));
      if (left <= step) approach();
      break;
    }
  }
  return place();
}

Quat ScriptedHand::orientation() const noexcept {
  // The sides face the user, never exactly away.
  const Quat q(1.0 + side_.z, -side_.y, side_.x, 0.0);
  return glm::normalize(q);
}

}  // namespace moltact
