// The firmware of a device with the open layout (docs/device-protocol.md) as plain logic: the reference for builders of
// devices, and the device's end in tests. It includes nothing of the program, so that it can be copied. Call take()
// with each report from USB, report() to send a position, and motors() from the motor loop. On a microcontroller none
// of these may interrupt another: disable interrupts during each call. Time is in microseconds, on a clock that may
// overflow. Units: millimetre, newton, in the program's axes.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace moltact::test {

/// The HID report descriptor. After usage page and usage: the length of each report after its id: 24, 10 and 31 bytes.
inline constexpr std::uint8_t kOpenReportDescriptor[] = {
    0x06, 0x00, 0xFF, 0x09, 0x01, 0xA1, 0x01,        // usage page 0xFF00, usage 1, application collection
    0x15, 0x00, 0x26, 0xFF, 0x00, 0x75, 0x08,        // every field is a byte from 0 to 255
    0x85, 0x01, 0x95, 0x18, 0x09, 0x02, 0x81, 0x02,  // report 1: 24 bytes in
    0x85, 0x02, 0x95, 0x0A, 0x09, 0x03, 0x91, 0x02,  // report 2: 10 bytes out
    0x85, 0x03, 0x95, 0x1F, 0x09, 0x04, 0xB1, 0x02,  // report 3: 31 bytes, feature
    0xC0,
};

class ReferenceFirmware {
 public:
  using Triple = std::array<double, 3>;
  static constexpr double kStep_mm = 0.005, kMax_N = 4.0;
  static constexpr int kDefaultWatchdog_ms = 50;

  /// The answer to GET_REPORT (feature, 3).
  std::array<std::uint8_t, 32> description() const {
    std::array<std::uint8_t, 32> r{3, 'M', 'L', 'T', 'C', 1};
    // Unit nm, peak mN, continuous mN, workspace mm, maximum stiffness N/m, damping, maximum damping mN s/m, friction
    // mN, delay us.
    const int fields[] = {5000, 4000, 1200, 180, 140, 100, 600, 150, 4000, 200, 1500};
    for (std::size_t k = 0; k < std::size(fields); ++k) put(r.data() + 6 + 2 * k, fields[k]);
    return r;
  }

  /// The next position report, for any place of the handle.
  std::array<std::uint8_t, 25> report(const Triple& place_mm, std::uint8_t buttons, std::uint32_t now_us) {
    std::array<std::uint8_t, 25> r{1};
    put(&r[1], ++number_);
    for (std::size_t k = 0; k < 4; ++k) r[3 + k] = std::uint8_t(now_us >> (8 * k));
    for (std::size_t k = 0; k < 3; ++k) put(&r[7 + 2 * k], within16(place_mm[k] / kStep_mm));
    put(&r[19], 32767);  // no rotation: quaternion (0, 0, 0, 1)
    r[21] = buttons;
    r[22] = std::uint8_t((fault ? 1 : 0) | (hot ? 2 : 0) | (calibrated ? 0 : 4) | (cut_ ? 8 : 0));
    put(&r[23], heard_);
    return r;
  }

  /// Handles a report from the host, which begins with its id. Ignores everything but force reports of the exact
  /// length.
  void take(const std::uint8_t* r, std::size_t bytes, std::uint32_t now_us) {
    if (bytes != 11 || r[0] != 2) return;
    heard_ = get(r + 1);
    for (std::size_t k = 0; k < 3; ++k) asked_N_[k] = 1e-3 * get(r + 3 + 2 * k);
    on_ = r[9] & 1;
    watchdog_us_ = 1000u * (r[10] ? r[10] : kDefaultWatchdog_ms);
    heard_us_ = now_us;
    cut_ = false;
  }

  /// The present force for the motors. Contains the watchdog, because the motor loop continues when USB stops.
  Triple motors(std::uint32_t now_us) {
    if (on_ && now_us - heard_us_ > watchdog_us_) {
      on_ = false;
      cut_ = true;
    }
    if (!on_ || fault || !calibrated) return {};
    const double size = std::hypot(asked_N_[0], asked_N_[1], asked_N_[2]), part = size > kMax_N ? kMax_N / size : 1.0;
    return {part * asked_N_[0], part * asked_N_[1], part * asked_N_[2]};
  }

  bool fault = false, hot = false, calibrated = true;

 private:
  // Saturates a position beyond 16 bits; an overflow would jump across the workspace.
  static int within16(double steps) { return int(std::lround(std::clamp(steps, -32767.0, 32767.0))); }
  static void put(std::uint8_t* at, int v) {
    at[0] = std::uint8_t(v & 0xFF);
    at[1] = std::uint8_t((v >> 8) & 0xFF);
  }
  static std::int16_t get(const std::uint8_t* at) { return std::int16_t(at[0] | at[1] << 8); }

  std::uint16_t number_ = 0;
  std::int16_t heard_ = 0;
  std::uint32_t heard_us_ = 0, watchdog_us_ = 1000u * kDefaultWatchdog_ms;
  bool on_ = false, cut_ = false;
  Triple asked_N_{};
};

}  // namespace moltact::test
