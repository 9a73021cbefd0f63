// WoodenHaptics (the 2015 design): an open stylus with three driven joints on USB. Reports have 8 bytes and no id.
// Input: three encoder counts and a counter. Output: three motor currents in mA and a number. The firmware cuts the
// motors 500 ms after the last report. The encoders count from the pose at power-on, or from an arbitrary one after the
// device was plugged in again. Therefore there is no force until the user has held both links upright and confirmed it.
#pragma once

#include "engine/device/packet/packet_protocol.h"

namespace moltact {

class WoodenHapticsProtocol final : public PacketProtocol {
 public:
  std::optional<Problem> begin(PacketPort& port, DeviceInfo& info) override;
  DeviceGuidance guidance() const noexcept override;
  bool calibrate() noexcept override;
  bool parseReport(std::span<const std::uint8_t> report, DevicePose& pose) noexcept override;
  std::size_t encode(const Wrench& wrench, ReportBuffer out) noexcept override;

  /// The handle's position for the given joint angles (unit: rad), in the program's axes.
  static PointMm place(const Vec3& angles);
  /// The joint torques that produce the force at the given joint angles (unit: N m).
  static Vec3 torques(const Vec3& angles, ForceN force);
  static constexpr double kCountsATurn = 2000, kTorque_Nm_per_A = 0.0259, kMax_mA = 3000;
  static constexpr double kGear[3] = {0.010 / 0.160, 0.010 / 0.120, 0.010 / 0.120};  ///< radius of capstan over body

 private:
  Vec3 angles_{0.0};
  std::int16_t counts_[3] = {}, upright_[3] = {};
  bool any_seen_ = false, calibrated_ = false;
  std::uint16_t sent_ = 0;
};

/// The device's published figures; the continuous force is a cautious estimate.
DeviceInfo woodenHapticsInfo();

}  // namespace moltact
