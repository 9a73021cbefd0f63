// Sony's DualShock 4 and DualSense, game pads with two motors that rumble. Over USB: in, report 1 of 64 bytes with
// sticks, buttons and triggers; out, a report with the motors' strengths. Over Bluetooth both send report 1 of 10
// bytes, laid out as the DualShock 4's; there they are not made to rumble, for their reports out are others. The left
// stick leads the hand right and up, the right trigger pushes it in, the left one draws it back; the right stick turns
// the view. How hard the surface pushes back is how strongly it rumbles: that is no force, and moves no hand.
#pragma once

#include "engine/device/hid/hid_device.h"

namespace moltact {

/// Where things stand in a pad's reports over USB.
struct PadLayout {
  std::size_t left_trigger, right_trigger, buttons;  ///< bytes of the report in
  std::uint8_t report, sets_motors;                  ///< the first two bytes of the report out
  std::size_t weak_motor, strong_motor, bytes;       ///< further bytes of it, and how many there are
};
inline constexpr PadLayout kDualShock4{8, 9, 5, 5, 1, 4, 5, 32};
inline constexpr PadLayout kDualSense{5, 6, 8, 2, 3, 3, 4, 48};

class PlayStationProtocol final : public HidProtocol {
 public:
  static constexpr double kFullRumble_N = 3.3;  ///< the force that is the strongest rumble

  explicit PlayStationProtocol(const PadLayout& usb = kDualShock4) : usb_(usb) {}

  std::optional<Problem> begin(HidPort&, DeviceInfo&) override;
  bool take(std::span<const std::uint8_t> report, DevicePose& pose) noexcept override;
  void pass(double dt_s, DevicePose& pose) noexcept override;
  ViewWish viewWish() const noexcept override { return wish_; }
  void turnHand(bool on) noexcept override { turns_hand_ = on; }
  std::size_t give(ForceN force, std::span<std::uint8_t, 64> out) noexcept override;
  std::size_t end(std::span<std::uint8_t, 64> out) noexcept override;

 private:
  PadLayout usb_;
  Vec3 push_{0.0}, turn_{0.0};
  ViewWish wish_;
  double silent_s_ = 0;
  bool by_usb_ = false, turns_hand_ = false;
  int told_ = -1;  // the step of rumble that was sent last; -1: none
};

}  // namespace moltact
