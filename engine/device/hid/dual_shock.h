// Sony's DualShock 4, a game pad with two motors that rumble. Over USB: in, report 1 of 64 bytes with sticks, buttons and
// triggers; out, report 5 of 32 bytes with the motors' strengths. Over Bluetooth it sends report 1 of 10 bytes that begins alike;
// there it is not made to rumble, for its reports out are others.
// The left stick leads the hand right and up, the right trigger pushes it in, the left one draws it back; the right stick
// turns the view. How hard the surface pushes back is how strongly it rumbles: that is no force, and moves no hand.
#pragma once

#include "engine/device/hid/hid_device.h"

namespace moltact {

class DualShockProtocol final : public HidProtocol {
 public:
  static constexpr double kFullRumble_N = 3.3;  ///< the force that is the strongest rumble

  std::optional<Problem> begin(HidPort&, DeviceInfo&) override;
  bool take(std::span<const std::uint8_t> report, DevicePose& pose) noexcept override;
  void pass(double dt_s, DevicePose& pose) noexcept override;
  ViewWish viewWish() const noexcept override { return wish_; }
  std::size_t give(ForceN force, std::span<std::uint8_t, 64> out) noexcept override;

 private:
  Vec3 push_{0.0}, turn_{0.0};
  ViewWish wish_;
  double silent_s_ = 0;
  bool by_usb_ = false;
  int told_ = -1;  // the step of rumble that was sent last; -1: none
};

}  // namespace moltact
