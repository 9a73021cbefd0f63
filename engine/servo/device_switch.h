// Selects the device that leads in this tick: the chosen one while it is there, else the fallback, in the same tick in
// which the chosen one disappeared; and the chosen one again when it is back. Haptic thread.
#pragma once

#include "engine/device/device.h"
#include "engine/servo/servo_step.h"

namespace moltact {

class DeviceSwitch {
 public:
  /// `chosen` may be null. Both must outlive the switch.
  DeviceSwitch(Device& fallback, Device* chosen) noexcept : fallback_(fallback), chosen_(chosen), used_(nullptr) {}

  /// The pose of this tick. Calls step.setDevice() when another device leads than before.
  DevicePose read(double dt_s, ServoStep& step) noexcept {
    DevicePose pose;
    Device* now = &fallback_;
    if (chosen_) {
      pose = chosen_->read(dt_s);
      if (pose.connected) now = chosen_;
    }
    // The fallback is read each time, so that it does not start from where it was long ago.
    const DevicePose other = fallback_.read(dt_s);
    if (now == &fallback_) pose = other;
    other_ = now != used_;
    if (other_) step.setDevice(now->info());
    used_ = now;
    return pose;
  }

  /// `stopped`: no force at all, with the motors off where the device can switch them.
  void write(const Wrench& wrench, bool stopped = false) noexcept {
    if (chosen_) stopped ? chosen_->stop() : chosen_->writeWrench(used_ == chosen_ ? wrench : Wrench{});
    if (used_ != chosen_ || !chosen_) fallback_.writeWrench(wrench);
  }

  /// True where another device leads in this tick than in the last.
  bool other() const noexcept { return other_; }
  /// The device that leads.
  const DeviceInfo& info() const noexcept { return (used_ ? used_ : &fallback_)->info(); }
  /// True while the fallback replaces a chosen device that is gone.
  bool fallenBack() const noexcept { return chosen_ && used_ == &fallback_; }

 private:
  Device& fallback_;
  Device* chosen_;
  Device* used_;
  bool other_ = false;
};

}  // namespace moltact
