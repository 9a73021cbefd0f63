// The device that is always present: a mouse or keyboard in place of a stylus. The window sets its target; the haptic
// thread reads it. Between two frames the position glides, so that the HIP moves in small steps at 1 kHz.
#pragma once

#include "engine/core/triple_buffer.h"
#include "engine/device/device.h"

namespace moltact {

class MouseDevice final : public Device {
 public:
  MouseDevice();
  const DeviceInfo& info() const noexcept override { return info_; }
  DevicePose read(double dt_s) noexcept override;
  void write(ForceN) noexcept override {}

  /// Window's thread: sets the hand's target. The hand approaches it with time constant kGlide_s and at most
  /// kMaxSpeed_mm_per_s. Non-finite positions are ignored.
  void lead(PointMm target) noexcept;
  /// Window's thread: moves the hand there at once (a new scene) and keeps its orientation. A lead() before the haptic
  /// thread's next read does not cancel this jump; the hand glides on from there.
  void place(PointMm target) noexcept;
  /// Window's thread: sets the target orientation, approached like the position, with at most kMaxSpeed_rad_per_s. A
  /// quaternion that is not a rotation is ignored.
  void turn(const Quat& orientation) noexcept;

  static constexpr double kGlide_s = 0.025;
  static constexpr double kMaxSpeed_mm_per_s = 400.0;
  static constexpr double kMaxSpeed_rad_per_s = 6.0;

 private:
  struct Lead {
    PointMm placed, target;  // the last jump, and the target of the glide
    Quat orientation = kNoRotation;
    std::uint32_t discontinuities = 0;
  };
  DeviceInfo info_{shownForceFigures()};
  TripleBuffer<Lead> lead_;
  Lead sent_;        // owned by the window
  DevicePose pose_;  // owned by the haptic thread
  std::uint32_t placed_ = 0;
};

}  // namespace moltact
