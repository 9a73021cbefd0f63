// A device's description that changes when another device is plugged in, readable by any thread meanwhile. Every
// version lives until the device is closed, so references stay valid that long.
#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "engine/device/device.h"

namespace moltact {

class VersionedDeviceInfo {
 public:
  explicit VersionedDeviceInfo(DeviceInfo first) { keep(std::move(first)); }
  VersionedDeviceInfo(const VersionedDeviceInfo&) = delete;
  VersionedDeviceInfo& operator=(const VersionedDeviceInfo&) = delete;

  /// Any thread, including the haptic one.
  const DeviceInfo& get() const noexcept { return *now_.load(std::memory_order_acquire); }
  /// One thread at a time, never the haptic one.
  void set(DeviceInfo info) {
    if (info != get()) keep(std::move(info));
  }

 private:
  void keep(DeviceInfo info) {
    all_.push_back(std::make_unique<const DeviceInfo>(std::move(info)));
    now_.store(all_.back().get(), std::memory_order_release);
  }

  std::vector<std::unique_ptr<const DeviceInfo>> all_;
  std::atomic<const DeviceInfo*> now_{nullptr};
};

}  // namespace moltact
