// Selects the device of each tick: the chosen one while it is connected, else the fallback. It switches in the same
// tick in which the chosen device disappears, and back when it returns. Haptic thread.
#pragma once

#include "engine/device/device.h"
#include "engine/servo/servo_step.h"

namespace moltact {

class DeviceSwitch {
 public:
  /// `chosen` may be null. Both must outlive the switch.
  DeviceSwitch(Device& fallback, Device* chosen) noexcept : fallback_(fallback), chosen_(chosen), used_(nullptr) {}

  /// Returns the pose of this tick. Calls step.setDevice() if the device differs from that of the last tick.
  DevicePose read(double dt_s, ServoStep& step) noexcept {
    DevicePose pose;
    Device* now = &fallback_;
    if (chosen_) {
      pose = chosen_->read(dt_s);
      if (pose.connected) now = chosen_;
    }
    // The fallback is read in every tick, so that it does not resume from an outdated position.
    const DevicePose other = fallback_.read(dt_s);
    if (now == &fallback_) pose = other;
    other_ = now != used_;
    if (other_) step.setDevice(now->info());
    used_ = now;
    return pose;
  }

  /// Writes the wrench to the device in use. `stopped`: no force, with the motors off if the device can switch them.
  void write(const Wrench& wrench, bool stopped = false) noexcept {
    if (chosen_) stopped ? chosen_->stop() : chosen_->writeWrench(used_ == chosen_ ? wrench : Wrench{});
    if (used_ != chosen_ || !chosen_) fallback_.writeWrench(wrench);
  }

  /// True if the device differs from that of the last tick.
  bool other() const noexcept { return other_; }
  /// The device in use.
  const DeviceInfo& info() const noexcept { return (used_ ? used_ : &fallback_)->info(); }
  /// True while the fallback replaces a disconnected chosen device.
  bool fallenBack() const noexcept { return chosen_ && used_ == &fallback_; }

 private:
  Device& fallback_;
  Device* chosen_;
  Device* used_;
  bool other_ = false;
};

}  // namespace moltact
