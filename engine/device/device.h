// The one interface of every haptic device: a pose comes in, a force goes out.
// `read` and `write` run on the haptic thread: no lock, allocation, exception, log or waiting.
// Units: millimetre and newton, in the device's space (+x right, +y up, +z toward the person).
#pragma once

#include <cstdint>
#include <string>

#include "engine/core/units.h"

namespace moltact {

/// What a device can do; read once, before it is used.
struct DeviceInfo {
  std::string name;                     ///< as the status bar says it
  Vec3 workspace_mm{160.0, 120.0, 70.0};///< the reach of the hand, edge to edge
  double max_force_N = 3.3;             ///< the greatest force for a moment
  double max_stiffness_N_per_mm = 1.0;  ///< the stiffest wall it can show
  bool gives_force = false;             ///< false: the force is only shown on the screen
};

struct DevicePose {
  PointMm position;
  std::uint32_t buttons = 0;  ///< a bit a button, the first in bit 0
  std::uint32_t placements = 0;  ///< raised by one when the hand was put elsewhere without a way between; a held device never does
};

class Device {
 public:
  virtual ~Device() = default;
  virtual const DeviceInfo& info() const noexcept = 0;
  /// The pose now; `dt_s` is the length of a tick.
  virtual DevicePose read(double dt_s) noexcept = 0;
  /// The force to give until the next tick: always finite and within max_force_N.
  virtual void write(ForceN force) noexcept = 0;
};

}  // namespace moltact
