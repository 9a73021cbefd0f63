// A recorded hand as a device: it moves as the recording did, whatever force it is given. Haptic thread.
#pragma once

#include "engine/servo/trace.h"

namespace moltact {

class PlaybackDevice final : public Device {
 public:
  /// At the recording's end the hand stays where it is. Without a tick in it the hand rests at the origin.
  explicit PlaybackDevice(DeviceTrace trace) : trace_(std::move(trace)) {
    if (!trace_.ticks.empty()) static_cast<DeviceFigures&>(info_) = trace_.ticks.front().device;
    info_.gives_force = false;
    info_.name = "Recording";
  }

  const DeviceInfo& info() const noexcept override { return info_; }
  DevicePose read(double) noexcept override {
    if (trace_.ticks.empty()) return {};
    const DevicePose pose = trace_.ticks[next_].pose;
    if (next_ + 1 < trace_.ticks.size()) ++next_;
    return pose;
  }
  void write(ForceN) noexcept override {}
  DeviceStatus status() override { return {}; }

 private:
  DeviceTrace trace_;
  DeviceInfo info_;
  std::size_t next_ = 0;
};

}  // namespace moltact
