// Devices that people build: any HID device that speaks the report layout of docs/device-protocol.md, on the vendor page
// 0xFF00, usage 1. It tells in a feature report what it is and can do.
#pragma once

#include "engine/device/hid/hid_device.h"

namespace moltact {

namespace open_layout {

inline constexpr std::uint8_t kPlaceReport = 1, kForceReport = 2, kDescription = 3, kVersion = 1;
inline constexpr std::size_t kPlaceBytes = 25, kForceBytes = 11, kDescriptionBytes = 32;
inline constexpr std::uint8_t kWatchdog_ms = 50;  ///< what the host asks for
/// Bits of a place report's status.
inline constexpr std::uint8_t kFault = 1, kHot = 2, kUncalibrated = 4, kWatchdogTripped = 8;

}  // namespace open_layout

class OpenProtocol final : public HidProtocol {
 public:
  std::optional<Problem> begin(HidPort& port, DeviceInfo& info) override;
  HidGuidance guidance() const noexcept override;
  bool take(std::span<const std::uint8_t> report, DevicePose& pose) noexcept override;
  std::size_t give(ForceN force, std::span<std::uint8_t, 64> out) noexcept override;

 private:
  double step_mm_ = 0.005;
  std::uint16_t seen_ = 0, sent_ = 0;
  std::uint8_t status_ = 0;
  bool any_seen_ = false, gives_ = false;
};

}  // namespace moltact
