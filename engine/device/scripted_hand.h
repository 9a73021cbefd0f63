// A scripted hand that explores the object at the middle of the workspace. It approaches from one side after another,
// presses until it feels about kPress_N, slides for some seconds and withdraws. Deterministic. Any thread; no
// allocation. Units: millimetre, newton, second.
#pragma once

#include "engine/core/units.h"

namespace moltact {

class ScriptedHand {
 public:
  static constexpr double kAway_mm = 60.0;
  static constexpr double kPress_N = 1.0;
  static constexpr double kApproach_mm_per_s = 50.0;
  static constexpr double kSlide_s = 3.0;

  ScriptedHand();

  /// The hand's target after `dt_s`, given the force that it felt.
  PointMm lead(double dt_s, ForceN felt) noexcept;
  /// Orientation of a stylus whose axis (z at rest) points to the side from which the hand approaches.
  Quat orientation() const noexcept;
  PointMm place() const noexcept { return {side_ * distance_mm_}; }

 private:
  enum class Doing { Approaches, Slides, Leaves, Turns };
  static Vec3 sideOf(int visit) noexcept;
  void approach() noexcept;

  Doing doing_ = Doing::Approaches;
  int visit_ = 0;
  Vec3 side_{0.0}, along_{0.0};  // orthonormal: the side of approach, and the direction of sliding
  double distance_mm_ = kAway_mm, slid_s_ = 0;
};

}  // namespace moltact
