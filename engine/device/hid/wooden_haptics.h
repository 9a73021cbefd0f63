// WoodenHaptics (the 2015 design): an open stylus of three driven joints on USB. Reports are 8 bytes without an id: in,
// three encoder counts and a counter; out, three motor currents in mA and a number. Its firmware cuts the motors 500 ms
// after the last report. Its encoders count from where it was switched on, or from anywhere after it was plugged in
// again. So there is no force until the person has held both links upright and confirmed it.
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

  /// The handle's position for the joints' angles (unit: rad), in the program's axes.
  static PointMm place(const Vec3& angles);
  /// The joints' torques that give the force at those angles (unit: N m).
  static Vec3 torques(const Vec3& angles, ForceN force);
  static constexpr double kCountsATurn = 2000, kTorque_Nm_per_A = 0.0259, kMax_mA = 3000;
  static constexpr double kGear[3] = {0.010 / 0.160, 0.010 / 0.120, 0.010 / 0.120};  ///< capstan over body

 private:
  Vec3 angles_{0.0};
  std::int16_t counts_[3] = {}, upright_[3] = {};
  bool any_seen_ = false, calibrated_ = false;
  std::uint16_t sent_ = 0;
};

/// The device's published figures; the continuous force is our own careful choice.
DeviceInfo woodenHapticsInfo();

}  // namespace moltact
