// Extends the reach beyond the device's workspace in two ways. While the clutch button is held, the probe stays and the
// hand moves and turns back (indexing), so that a body can be turned farther than a wrist turns. When the hand is at the
// edge of its workspace, the probe drifts outward slowly (rate control). Haptic thread. Units: millimetre, second. Quat
// is constructed as (w, x, y, z).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "engine/device/device.h"

namespace moltact {

struct ClutchSettings {
  std::uint32_t buttons = 0;  ///< bits of the clutch buttons; 0: none
  bool at_edge = false;       ///< enables the drift while the hand is within kEdge_mm of its workspace's edge
};

class Clutch {
 public:
  static constexpr double kEdge_mm = 10.0;
  static constexpr double kDrift_mm_per_s = 20.0;  ///< at the edge itself
  /// A stylus that has moved less than kStill_mm for kLetGo_s counts as released: in its stand or hanging. It does not
  /// drift.
  static constexpr double kStill_mm = 0.2, kLetGo_s = 1.5;

  /// The hand continues from its position; its orientation keeps what earlier grips have added.
  void restart() noexcept { offset_mm_ = Vec3(0.0), held_ = false; }
  /// Also forgets the orientation's grips: for another device, or a hand that was lost.
  void forget() noexcept { restart(), turned_ = kNoRotation; }

  /// Returns the probe's position for a pose, in the device's space; it may lie outside the workspace. Non-finite
  /// positions pass unchanged. `push` is the direction of the surface's force in the last tick (unit length, or zero).
  /// At the edge the probe drifts along the surface or away from it, never deeper.
  PointMm place(const DevicePose& pose, const ClutchSettings& settings, const Vec3& workspace_mm, const Vec3& push,
                double dt_s) noexcept {
    const Vec3& now = pose.position.mm;
    if (!finite(now)) return pose.position;
    const bool holds = pose.buttons & settings.buttons;
    if (holds && held_) offset_mm_ += last_mm_ - now;
    regrip(pose.orientation, holds && held_);
    held_ = holds;
    last_mm_ = now;
    const bool moves = glm::distance(now, rest_mm_) > kStill_mm;
    still_s_ = moves ? 0.0 : still_s_ + dt_s;
    if (moves) rest_mm_ = now;
    if (settings.at_edge && !holds && !pose.fault && still_s_ < kLetGo_s) {
      const Vec3 onward = drift(now, workspace_mm) * (kDrift_mm_per_s * dt_s);
      offset_mm_ += onward - push * std::min(0.0, glm::dot(onward, push));
    }
    return {now + offset_mm_};
  }

  /// The orientation after place() of the same pose: that of the stylus times the grips' offset. A rotation of the
  /// stylus about the device's axes is one of the hand about the same axes. An orientation that is no rotation passes
  /// unchanged, and without a grip every orientation does, to the last bit.
  Quat orient(const Quat& stylus) const noexcept {
    return turned_ == kNoRotation || !rotates(stylus) ? stylus : glm::normalize(stylus * turned_);
  }

  /// True while the hand moves without the probe. There must then be no force, which would push the free hand.
  bool held() const noexcept { return held_; }

 private:
  friend struct StepState;  // step_state.cpp, which saves the state
  // The position relative to the edge zone per axis: 0 at its inner side, 1 at the edge and beyond.
  static Vec3 drift(const Vec3& place_mm, const Vec3& workspace_mm) noexcept {
    Vec3 out(0.0);
    for (int k = 0; k < 3; ++k) {
      const double beyond = std::abs(place_mm[k]) - std::max(0.0, 0.5 * workspace_mm[k] - kEdge_mm);
      if (beyond > 0.0) out[k] = std::copysign(std::min(1.0, beyond / kEdge_mm), place_mm[k]);
    }
    return out;
  }

  // With q turned_ = q_last turned_last the hand's orientation stays while the stylus turns from q_last to q.
  void regrip(const Quat& stylus, bool holds) noexcept {
    if (!rotates(stylus)) return;
    if (holds && stylus != last_stylus_) turned_ = glm::normalize(glm::conjugate(stylus) * last_stylus_ * turned_);
    last_stylus_ = stylus;
  }

  Vec3 offset_mm_{0.0}, last_mm_{0.0}, rest_mm_{0.0};
  Quat turned_ = kNoRotation, last_stylus_ = kNoRotation;
  double still_s_ = 0.0;
  bool held_ = false;
};

}  // namespace moltact
