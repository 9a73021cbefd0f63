// The device that is always there: a mouse or keyboard in place of a stylus. The window leads it, the haptic thread
// reads it; between two frames it glides, so that the HIP moves in small steps at 1 kHz.
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

  /// The window's thread: sets the target of the hand. It glides there, with a time constant of kGlide_s and at most
  /// kFastest_mm_per_s. Non-finite places are ignored.
  void lead(PointMm target) noexcept;
  /// The window's thread: the hand is there at once (a new scene), turned as it was. Where it is led on before the
  /// haptic thread has read it, it is there first all the same, and glides on.
  void place(PointMm target) noexcept;
  /// The window's thread: how the hand is to be turned; it turns there as it glides, at most kFastest_rad_per_s. What
  /// is no rotation is ignored.
  void turn(const Quat& orientation) noexcept;

  static constexpr double kGlide_s = 0.025;
  static constexpr double kFastest_mm_per_s = 400.0;
  static constexpr double kFastest_rad_per_s = 6.0;

 private:
  struct Lead {
    PointMm placed, target;  // where the hand was put last, and where it is to go
    Quat orientation = kNoRotation;
    std::uint32_t discontinuities = 0;
  };
  DeviceInfo info_{shownForceFigures()};
  TripleBuffer<Lead> lead_;
  Lead sent_;        // the window's
  DevicePose pose_;  // the haptic thread's
  std::uint32_t placed_ = 0;
};

}  // namespace moltact
