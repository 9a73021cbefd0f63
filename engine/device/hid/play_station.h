// Sony's DualShock 4 and DualSense, game pads with two rumble motors. Over USB, input is report 1 of 64 bytes with
// sticks, buttons and triggers, and output a report with the motors' strengths. Over Bluetooth both send report 1 of 10
// bytes in the DualShock 4's layout; they do not rumble there, because their output reports differ.
//
// The left stick moves the hand right and up, the right trigger pushes it in, the left trigger draws it back; the right
// stick rotates the view. The strength of the rumble indicates the force of the surface; it does not move the hand.
#pragma once

#include "engine/device/packet/packet_protocol.h"

namespace moltact {

/// Offsets in a pad's USB reports.
struct PadLayout {
  std::size_t left_trigger, right_trigger, buttons;  ///< in the input report
  std::uint8_t report, sets_motors;                  ///< first two bytes of the output report
  std::size_t weak_motor, strong_motor, bytes;       ///< offsets in the output report, and its length
};
inline constexpr PadLayout kDualShock4{8, 9, 5, 5, 1, 4, 5, 32};
inline constexpr PadLayout kDualSense{5, 6, 8, 2, 3, 3, 4, 48};

class PlayStationProtocol final : public PacketProtocol {
 public:
  static constexpr double kFullRumble_N = 3.3;  ///< force of the strongest rumble

  explicit PlayStationProtocol(const PadLayout& usb = kDualShock4) : usb_(usb) {}

  std::optional<Problem> begin(PacketPort&, DeviceInfo&) override;
  bool parseReport(std::span<const std::uint8_t> report, DevicePose& pose) noexcept override;
  void advance(double dt_s, DevicePose& pose) noexcept override;
  ViewMotion viewMotion() const noexcept override { return view_motion_; }
  void rotateHand(bool on) noexcept override { rotates_hand_ = on; }
  std::size_t encode(const Wrench& wrench, ReportBuffer out) noexcept override;
  std::size_t encodeFinalReport(ReportBuffer out) noexcept override;

 private:
  PadLayout usb_;
  Vec3 push_{0.0}, turn_{0.0};
  ViewMotion view_motion_;
  double silent_s_ = 0;
  bool by_usb_ = false, rotates_hand_ = false;
  int sent_step_ = -1;  // the rumble step sent last; -1: none
};

}  // namespace moltact
