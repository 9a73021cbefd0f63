// 3Dconnexion SpaceMouse: six axes that tell how far the cap is pushed and turned, no force. A push sets the hand's
// speed, a turn the view's, whichever is the stronger. The first button switches: the push then moves the view, until
// it is pressed again. Where a body is felt a turn turns it, and the view only while the push moves that.
#pragma once

#include "engine/device/hid/hid_device.h"

namespace moltact {

/// The cap's push and turn: each -1 to 1, along and round the device's axes (+x right, +y up, +z toward the person).
struct SixAxes {
  Vec3 push{0.0}, rotation{0.0};
};

class SpaceMouseProtocol final : public HidProtocol {
 public:
  static constexpr double kFull = 350.0;  ///< what the device tells at its stops

  /// A push from before an unplugging is over.
  std::optional<Problem> begin(HidPort&, DeviceInfo&) override;
  bool take(std::span<const std::uint8_t> report, DevicePose& pose) noexcept override;
  void pass(double dt_s, DevicePose& pose) noexcept override;
  ViewWish viewWish() const noexcept override { return wish_; }
  void turnHand(bool on) noexcept override { turns_hand_ = on; }
  const SixAxes& axes() const { return axes_; }

 private:
  SixAxes axes_;
  ViewWish wish_;
  std::uint32_t pressed_ = 0;
  bool leads_view_ = false, turns_hand_ = false;
  double silent_s_ = 0;
};

}  // namespace moltact
