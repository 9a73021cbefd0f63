// Plays a recorded hand as a device. It moves as recorded, whatever the force. Haptic thread unless stated otherwise.
#pragma once

#include <atomic>

#include "engine/language/catalogue.h"
#include "engine/servo/servo_recording.h"

namespace moltact {

class PlaybackDevice final : public Device {
 public:
  /// At the end of the recording the hand stays in place. An empty recording gives a hand at rest at the origin.
  explicit PlaybackDevice(ServoRecording recording) : recording_(std::move(recording)) {
    if (!recording_.ticks.empty()) static_cast<DeviceSpecs&>(info_) = recording_.ticks.front().device;
    info_.gives_force = false;
    info_.name = N_("Recorded hand");
  }

  const DeviceInfo& info() const noexcept override { return info_; }
  DevicePose read(double) noexcept override {
    if (recording_.ticks.empty()) return {};
    const std::size_t now = next_.load(std::memory_order_relaxed);
    if (now + 1 < recording_.ticks.size())
      next_.store(now + 1, std::memory_order_relaxed);
    else
      ended_.store(true, std::memory_order_relaxed);
    return recording_.ticks[now].pose;
  }
  void write(ForceN) noexcept override {}

  /// Any thread: index of the next tick, the recording, and true after its last tick has been read.
  std::size_t at() const noexcept { return next_.load(std::memory_order_relaxed); }
  const ServoRecording& recording() const noexcept { return recording_; }
  bool ended() const noexcept { return recording_.ticks.empty() || ended_.load(std::memory_order_relaxed); }

 private:
  ServoRecording recording_;
  DeviceInfo info_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> ended_{false};
};

}  // namespace moltact
