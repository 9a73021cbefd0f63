// The reference firmware on the test's clock: a tick is one millisecond, in which the motor loop runs and a position is
// sent. Units: millimetre, newton.
#pragma once

#include <span>

#include "engine/core/units.h"
#include "tests/device/reference_firmware.h"

namespace moltact::test {

class OpenFirmware : public ReferenceFirmware {
 public:
  /// Advances one millisecond with the handle at that position. Returns the report to send.
  std::array<std::uint8_t, 25> tick(const Vec3& place_mm, std::uint8_t buttons = 0) {
    now_us_ += 1000;
    force_N();
    return report({place_mm.x, place_mm.y, place_mm.z}, buttons, now_us_);
  }
  void take(std::span<const std::uint8_t> r) { ReferenceFirmware::take(r.data(), r.size(), now_us_); }
  /// The present force of the motors.
  Vec3 force_N() {
    const Triple f = motors(now_us_);
    return {f[0], f[1], f[2]};
  }

 private:
  std::uint32_t now_us_ = 0;
};

}  // namespace moltact::test
