// 3Dconnexion SpaceMouse: six axes that report translation and rotation of the cap; no force. A push sets the hand's
// speed, a rotation that of the view; only the stronger of the two acts. The first button toggles: a push then moves
// the view instead of the hand. If the hand holds a body, a rotation of the cap rotates the body; it rotates the view
// only while a push moves the view.
#pragma once

#include "engine/device/packet/packet_protocol.h"

namespace moltact {

/// Deflection of the cap: components -1 to 1, along and about the device's axes (+x right, +y up, +z toward the user).
struct SixAxes {
  Vec3 push{0.0}, rotation{0.0};
};

class SpaceMouseProtocol final : public PacketProtocol {
 public:
  static constexpr double kFull = 350.0;  ///< reported value at the mechanical stop

  /// Discards a deflection from before an unplugging.
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
