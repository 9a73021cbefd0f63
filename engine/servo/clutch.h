// Reaching farther than the device does. While the clutch's button is held, the probe stays and the hand moves back;
// and where the hand is pushed to the edge of its workspace, the probe drifts on slowly. Haptic thread. Units:
// millimetre, second.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "engine/device/device.h"

namespace moltact {

struct ClutchSettings {
  std::uint32_t buttons = 0;  ///< bits of the buttons that operate the clutch; 0: none
  bool at_edge = false;       ///< the probe drifts on where the hand is within kEdge_mm of its workspace's edge
};

class Clutch {
 public:
  static constexpr double kEdge_mm = 10.0;
  static constexpr double kDrift_mm_per_s = 20.0;  ///< at the very edge
  /// A stylus that moved no farther for so long lies in its stand or hangs.
  static constexpr double kStill_mm = 0.2, kLetGo_s = 1.5;

  void restart() noexcept { offset_mm_ = Vec3(0.0), held_ = false; }

  /// The probe's place for that pose, in the device's space and beyond. Non-finite places pass unchanged. `push` is the
  /// direction in which a surface pushed the hand in the last tick (length 1, or zero): at the edge the probe drifts
  /// along the surface and off it, never deeper.
  PointMm place(const DevicePose& pose, const ClutchSettings& settings, const Vec3& workspace_mm, const Vec3& push,
                double dt_s) noexcept {
    const Vec3& now = pose.position.mm;
    if (!finite(now)) return pose.position;
    const bool holds = pose.buttons & settings.buttons;
    if (holds && held_) offset_mm_ += last_mm_ - now;
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

  /// Whether the hand moves without the probe. Then there must be no force, for it would push the hand about.
  bool held() const noexcept { return held_; }

 private:
  friend struct StepState;  // step_state.cpp, which keeps it
  // How far beyond the inner part of the workspace along each axis: 1 at its edge and farther.
  static Vec3 drift(const Vec3& place_mm, const Vec3& workspace_mm) noexcept {
    Vec3 out(0.0);
    for (int k = 0; k < 3; ++k) {
      const double beyond = std::abs(place_mm[k]) - std::max(0.0, 0.5 * workspace_mm[k] - kEdge_mm);
      if (beyond > 0.0) out[k] = std::copysign(std::min(1.0, beyond / kEdge_mm), place_mm[k]);
    }
    return out;
  }

  Vec3 offset_mm_{0.0}, last_mm_{0.0}, rest_mm_{0.0};
  double still_s_ = 0.0;
  bool held_ = false;
};

}  // namespace moltact
