// Reaching farther than the device does: while the clutch's button is held the probe stays and the hand goes back; and
// where the hand is pushed beyond the edge of its room, the probe goes on slowly. Haptic thread. Units: millimetre, second.
#pragma once

#include <algorithm>
#include <cstdint>

#include "engine/device/device.h"

namespace moltact {

struct ClutchSettings {
  std::uint32_t buttons = 0;  ///< bits of the buttons that hold the clutch; 0: none
  bool at_edge = false;       ///< the probe goes on where the hand is within kEdge_mm of its room's edge
};

class Clutch {
 public:
  static constexpr double kEdge_mm = 10.0;
  static constexpr double kDrift_mm_per_s = 20.0;  ///< at the very edge

  void restart() noexcept { offset_mm_ = Vec3(0.0), held_ = false; }

  /// Where the probe is for that pose, in the device's space and beyond. Non-finite places pass as they are.
  PointMm place(const DevicePose& pose, const ClutchSettings& settings, const Vec3& workspace_mm, double dt_s) noexcept {
    if (!finite(pose.position.mm)) return pose.position;
    const bool holds = pose.buttons & settings.buttons;
    if (holds && held_) offset_mm_ += last_mm_ - pose.position.mm;
    held_ = holds;
    last_mm_ = pose.position.mm;
    if (settings.at_edge && !holds)
      for (int k = 0; k < 3; ++k) {
        const double inner = std::max(0.0, 0.5 * workspace_mm[k] - kEdge_mm), beyond = std::abs(pose.position.mm[k]) - inner;
        if (beyond > 0.0)
          offset_mm_[k] += (pose.position.mm[k] > 0 ? 1.0 : -1.0) * std::min(1.0, beyond / kEdge_mm) * kDrift_mm_per_s * dt_s;
      }
    return {pose.position.mm + offset_mm_};
  }

  /// Whether the hand moves without the probe: then there is to be no force, for the hand would carry it about.
  bool held() const noexcept { return held_; }

 private:
  Vec3 offset_mm_{0.0}, last_mm_{0.0};
  bool held_ = false;
};

}  // namespace moltact
