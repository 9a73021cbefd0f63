// What the firmware of a device of the open layout does (docs/device-protocol.md), as plain logic: the reference for those
// who build one, and the far end of the tests. A tick is a millisecond. Units: millimetre, newton.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "engine/core/units.h"

namespace moltact::test {

class OpenFirmware {
 public:
  static constexpr double kStep_mm = 0.005, kMost_N = 4.0;

  std::array<std::uint8_t, 32> description() const {
    std::array<std::uint8_t, 32> r{3, 'M', 'L', 'T', 'C', 1};
    const int fields[] = {5000, 4000, 1200, 180, 140, 100, 600, 150, 4000, 200, 1500};
    for (std::size_t k = 0; k < std::size(fields); ++k) put(r, 6 + 2 * k, fields[k]);
    r[28] = 0;
    return r;
  }

  /// A millisecond passes with the handle at that place: the report to send.
  std::array<std::uint8_t, 25> tick(const Vec3& place_mm, std::uint8_t buttons = 0) {
    // The watchdog: without a force report for so long the motors go off until the next one.
    if (enabled_ && ++silent_ms_ > watchdog_ms_) {
      enabled_ = false;
      tripped_ = true;
    }
    std::array<std::uint8_t, 25> r{1};
    put(r, 1, ++sequence_);
    const std::uint32_t t_us = 1000u * ++time_ms_;
    for (std::size_t k = 0; k < 4; ++k) r[3 + k] = std::uint8_t(t_us >> (8 * k));
    for (int k = 0; k < 3; ++k) put(r, 7 + 2 * std::size_t(k), int(std::lround(place_mm[k] / kStep_mm)));
    put(r, 19, 32767);  // turned by nothing: quaternion (0, 0, 0, 1)
    r[21] = buttons;
    r[22] = std::uint8_t((fault ? 1 : 0) | (hot ? 2 : 0) | (tripped_ ? 8 : 0));
    put(r, 23, last_force_);
    return r;
  }

  /// A report from the host. What is no force report of the right length is ignored.
  void take(std::span<const std::uint8_t> r) {
    if (r.size() < 11 || r[0] != 2) return;
    last_force_ = std::uint16_t(get(r, 1));
    for (int k = 0; k < 3; ++k) force_N_[k] = 1e-3 * get(r, 3 + 2 * std::size_t(k));
    enabled_ = r[9] & 1;
    watchdog_ms_ = r[10] ? r[10] : 50;
    silent_ms_ = 0;
    tripped_ = false;
  }

  /// What the motors give now.
  Vec3 force_N() const {
    if (!enabled_ || fault) return Vec3(0.0);
    const double size = glm::length(force_N_);
    return size > kMost_N ? force_N_ * (kMost_N / size) : force_N_;
  }

  bool fault = false, hot = false;

 private:
  static void put(std::span<std::uint8_t> r, std::size_t at, int v) {
    r[at] = std::uint8_t(v & 0xFF);
    r[at + 1] = std::uint8_t((v >> 8) & 0xFF);
  }
  static int get(std::span<const std::uint8_t> r, std::size_t at) { return std::int16_t(r[at] | r[at + 1] << 8); }

  std::uint16_t sequence_ = 0, last_force_ = 0;
  std::uint32_t time_ms_ = 0;
  int silent_ms_ = 0, watchdog_ms_ = 50;
  bool enabled_ = false, tripped_ = false;
  Vec3 force_N_{0.0};
};

}  // namespace moltact::test
