// 3Dconnexion SpaceMouse: six axes that tell how far the cap is pushed and turned, no force. The hand goes with a speed that
// the push sets, and the view may turn with the rest (axes()).
#pragma once

#include "engine/device/hid/hid_device.h"

namespace moltact {

/// The cap's push and turn: each -1 to 1, along and round the device's axes (+x right, +y up, +z toward the person).
struct SixAxes {
  Vec3 push{0.0}, turn{0.0};
};

class SpaceMouseProtocol final : public HidProtocol {
 public:
  static constexpr double kFull = 350.0;            ///< what the device tells at its stops
  static constexpr double kDead = 0.05;             ///< of it: less counts as rest
  static constexpr double kFastest_mm_per_s = 60.0; ///< of the hand, at a full push
  static constexpr double kSilence_s = 0.25;        ///< after it a push counts as let go: a report was lost
  static constexpr double kReach_mm = 80.0;         ///< the hand goes no farther from the middle on any axis

  /// A push from before an unplugging is over.
  std::optional<Problem> begin(HidPort&, DeviceInfo&) override;
  bool take(std::span<const std::uint8_t> report, DevicePose& pose) noexcept override;
  void pass(double dt_s, DevicePose& pose) noexcept override;
  const SixAxes& axes() const { return axes_; }

 private:
  SixAxes axes_;
  double silent_s_ = 0;
};

}  // namespace moltact
