// The one interface of every haptic device: a pose comes in, a force or a wrench goes out.
// `read` and `write` run on the haptic thread: no lock, allocation, exception, log or waiting.
// Units: millimetre and newton, in the device's space (+x right, +y up, +z toward the person).
#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include "engine/core/units.h"

namespace moltact {

/// What a device can do, in numbers. Defaults are the Phantom Omni's, as published by its vendor and measured in the
/// literature; docs/devices.md says which is which.
struct DeviceSpecs {
  Vec3 workspace_mm{160.0, 120.0, 70.0};  ///< the reach of the hand, edge to edge
  int dof_in = 3;                         ///< degrees of freedom that are read and used: 3 place, 6 place and turn
  int dof_out = 0;                        ///< degrees of freedom that are driven: 0 none, 3 force, 6 force and torque
  double max_force_N = 3.3;               ///< the greatest force for a moment
  double continuous_force_N = 3.3;        ///< the greatest force for good, by the motors' heat
  double max_stiffness_N_per_mm = 1.0;    ///< the stiffest wall it can show
  double max_damping_N_s_per_m = 5.0;     ///< the greatest damping it can show
  double damping_N_s_per_m = 0.2;         ///< its own, in the mechanism
  double friction_N = 0.26;               ///< its own, Coulomb; 0: not known
  double resolution_mm = 0.055;           ///< the least step of the place that it tells
  double delay_s = 0.001;                 ///< from the encoders to the driver and from there to the motors, together
  double speed_limit_m_per_s = kNoLimit;  ///< faster than this it gives no force
  double slew_limit_N_per_s = kNoLimit;   ///< and a force that changes faster it cuts
  double max_torque_N_mm = 0.0;           ///< the greatest torque; 0 where it drives none
  bool gives_force = false;               ///< false: the force is only shown on the screen, and moves no hand

  static constexpr double kNoLimit = std::numeric_limits<double>::infinity();
  friend bool operator==(const DeviceSpecs&, const DeviceSpecs&) = default;
};

/// A device, described once, before it is used.
struct DeviceInfo : DeviceSpecs {
  std::string name;  ///< as the status bar says it: by `tr`, for a name of ours is in English
  friend bool operator==(const DeviceInfo&, const DeviceInfo&) = default;
};

struct DevicePose {
  PointMm position;           ///< from the middle of workspace_mm
  std::uint32_t buttons = 0;  ///< a bit a button, the first in bit 0
  std::uint32_t discontinuities =
      0;              ///< raised by one when the hand was put elsewhere without a way between; a held device never does
  bool fresh = true;  ///< false: nothing new has come from the device since the last read; the place is the last one
  bool connected = true;  ///< false: the device is gone
  bool fault = false;     ///< the device itself reports a fault, or is not calibrated: no force
  float motor_heat = 0;   ///< 0 cold to 1 as warm as its motors may be, where it tells
  float age_s = 0;        ///< how old the place is when it is read, with the wait of the force that answers it, as the
                          ///< driver measures them of its own thread: on top of DeviceSpecs::delay_s
  Quat orientation = kNoRotation;  ///< of what is in the hand, from the device's axes; none where it measures none
};

/// How fast a person wants the view to move and to turn, each -1 to 1 along and round the screen's axes (+x right, +y
/// up, +z toward the person); what is seen goes with the hand.
struct ViewWish {
  Vec3 move{0.0}, rotation{0.0};
};

/// How a device is, in words for the person who holds it.
struct DeviceStatus {
  bool connected = true;
  bool ready = true;  ///< false: it gives no force yet, or its places are not to be trusted; `text` says what to do
  std::string text;   ///< what is wrong, or what the person is to do; empty: nothing
  bool asks_calibrate = false;  ///< it waits for calibrate(), when what `text` says has been done
  double motor_heat = -1.0;  ///< 0 cold to 1 as warm as its motors may be, as the device tells it; -1: it does not tell
};

/// What a device with a clock of its own calls once a tick, on its own thread.
class TickTarget {
 public:
  virtual void tickOfDevice() noexcept = 0;

 protected:
  ~TickTarget() = default;
};

/// Made open, by its driver (driver.h); closed, without force, when it is destroyed.
class Device {
 public:
  virtual ~Device() = default;
  virtual const DeviceInfo& info() const noexcept = 0;
  /// The pose now; `dt_s` is the length of a tick.
  virtual DevicePose read(double dt_s) noexcept = 0;
  /// The force to give until the next tick: always finite and within max_force_N.
  virtual void write(ForceN force) noexcept = 0;
  /// The same with a torque, for a device of dof_out 6; others are given the force alone.
  virtual void writeWrench(const Wrench& wrench) noexcept { write(wrench.force); }
  /// In place of write(): no force, and the motors off where the device can, until the next write.
  virtual void stop() noexcept { write(ForceN{}); }

  /// The window's thread, a few times a second: may take a while, and does what is not for the haptic thread.
  virtual DeviceStatus status() { return {}; }
  /// The window's thread, each frame.
  virtual ViewWish viewWish() noexcept { return {}; }
  /// The window's thread: whether what turns on the device turns the hand from now on, and no longer the view. One that
  /// measures the hand's own turn does so always.
  virtual void turnHand(bool) noexcept {}
  /// The window's thread: the person holds the device as status() asked for its calibration.
  virtual void calibrate() {}

  /// The window's thread. A device whose driver brings a clock calls `target` by it from now on and returns true;
  /// others return false and are read by the loop's own clock.
  virtual bool startClock(TickTarget&) { return false; }
  /// The window's thread: after it returns the target is not called any more.
  virtual void stopClock() {}
};

}  // namespace moltact
