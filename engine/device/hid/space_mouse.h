// 3Dconnexion SpaceMouse: six axes that report how far the cap is pushed and turned; no force. A push sets the hand's
// speed, a turn the view's, whichever is the stronger. The first button is a switch: the push then moves the view,
// until it is pressed again. Where the hand holds a body, a turn turns that body; it turns the view only while the push
// moves the view.
#pragma once

#include "engine/device/packet/packet_protocol.h"

namespace moltact {

/// The cap's push and turn: each -1 to 1, along and round the device's axes (+x right, +y up, +z toward the person).
struct SixAxes {
  Vec3 push{0.0}, rotation{0.0};
};

class SpaceMouseProtocol final : public PacketProtocol {
 public:
  static constexpr double kFull = 350.0;  ///< the value that the device reports at its stops

  /// Forgets a push from before an unplugging.
  std::optional<Problem> begin(PacketPort&, DeviceInfo&) override;
  bool parseReport(std::span<const std::uint8_t> report, DevicePose& pose) noexcept override;
  void advance(double dt_s, DevicePose& pose) noexcept override;
  ViewMotion viewMotion() const noexcept override { return view_motion_; }
  void rotateHand(bool on) noexcept override { rotates_hand_ = on; }
  const SixAxes& axes() const { return axes_; }

 private:
  SixAxes axes_;
  ViewMotion view_motion_;
  std::uint32_t pressed_ = 0;
  bool leads_view_ = false, rotates_hand_ = false;
  double silent_s_ = 0;
};

}  // namespace moltact
