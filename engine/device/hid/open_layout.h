// Self-built devices: any HID device with the report layout of docs/device-protocol.md, on the vendor page 0xFF00,
// usage 1. Its feature report describes the device. The layout has no torque, so such a device receives forces alone
// (DeviceSpecs::dof_out 3).
#pragma once

#include "engine/device/packet/packet_protocol.h"

namespace moltact {

namespace open_layout {

inline constexpr std::uint16_t kUsagePage = 0xFF00, kUsage = 1;
inline constexpr std::uint8_t kPlaceReport = 1, kForceReport = 2, kDescription = 3, kVersion = 1;
/// Lengths including the report id.
inline constexpr std::size_t kPlaceBytes = 25, kForceBytes = 11, kDescriptionBytes = 32;
inline constexpr std::uint8_t kWatchdog_ms = 50;  ///< watchdog time requested by the host
/// Status bits of a position report.
inline constexpr std::uint8_t kFault = 1, kHot = 2, kUncalibrated = 4, kWatchdogTripped = 8;
inline constexpr std::uint8_t kMeasuresOrientation = 1;  ///< of byte 28 of the description

}  // namespace open_layout

class OpenLayoutProtocol final : public PacketProtocol {
 public:
  std::optional<Problem> begin(PacketPort& port, DeviceInfo& info) override;
  bool ofKind() const noexcept override { return of_kind_; }
  DeviceGuidance guidance() const noexcept override;
  bool parseReport(std::span<const std::uint8_t> report, DevicePose& pose) noexcept override;
  void advance(double dt_s, DevicePose& pose) noexcept override;
  std::size_t encode(const Wrench& wrench, ReportBuffer out) noexcept override;
  std::size_t encodeStop(ReportBuffer out) noexcept override;

 private:
  std::size_t forceReport(ForceN force, bool motors_on, ReportBuffer out) noexcept;
  bool faulty() const { return (status_ & (open_layout::kFault | open_layout::kUncalibrated)) || cut_s_ > 0; }

  double step_mm_ = 0.005;
  bool measures_orientation_ = false;
  std::uint16_t seen_ = 0, sent_ = 0;
  std::uint8_t status_ = 0;  // of the newest position report
  bool any_seen_ = false, gives_ = false, of_kind_ = true;
  double cut_s_ = 0;  // remaining time for which the device's watchdog is assumed to have cut the motors
};

}  // namespace moltact
