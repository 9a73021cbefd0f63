// The one interface of every haptic device: a pose comes in, a force or a wrench goes out.
// `read` and `write` run on the haptic thread: no lock, allocation, exception, log or waiting.
// Units: millimetre and newton, in the device's space (+x right, +y up, +z toward the person).
#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include "engine/core/units.h"

namespace moltact {

/// A device's capabilities. A driver names each figure that it knows. What it leaves out counts as not known, and the
/// less force is given: none at all without both of the forces, softer springs without the others
/// (engine/servo/safety_stage.h).
struct DeviceSpecs {
  static constexpr double kNoLimit = std::numeric_limits<double>::infinity();
  static constexpr double kUnknownStiffness_N_per_mm = 0.3, kUnknownDelay_s = 0.002, kUnknownResolution_mm = 0.1;

  Vec3 workspace_mm{160.0, 120.0, 70.0};  ///< the reach of the hand, edge to edge
  int dof_in = 3;            ///< degrees of freedom that are read and used: 3 position, 6 position and orientation
  int dof_out = 0;           ///< degrees of freedom that are driven: 0 none, 3 force, 6 force and torque
  double max_force_N = 0.0;  ///< the greatest force for a moment
  double continuous_force_N = 0.0;                             ///< the greatest force for good, by the motors' heat
  double max_stiffness_N_per_mm = kUnknownStiffness_N_per_mm;  ///< the stiffest wall it can show
  double max_damping_N_s_per_m = 0.0;                          ///< the greatest damping it can show
  double damping_N_s_per_m = 0.0;                              ///< of the mechanism itself
  double friction_N = 0.0;                                     ///< of the mechanism itself, Coulomb; 0: not known
  double resolution_mm = kUnknownResolution_mm;                ///< the least step of the position that it reports
  double delay_s = kUnknownDelay_s;       ///< from the encoders to the driver plus from there to the motors
  double speed_limit_m_per_s = kNoLimit;  ///< the device gives no force to a hand faster than this
  double slew_limit_N_per_s = kNoLimit;   ///< the device cuts a force that changes faster
  double max_torque_N_mm = 0.0;           ///< the greatest torque; 0 where it drives none
  bool gives_force = false;               ///< false: the force is shown on the screen only and moves no hand

  friend bool operator==(const DeviceSpecs&, const DeviceSpecs&) = default;
};

/// The figures of the Phantom Omni's motors and mechanism, as its vendor published them and as they were measured in
/// the literature; docs/devices.md says which is which.
inline DeviceSpecs phantomOmniFigures() noexcept {
  DeviceSpecs out;
  out.max_force_N = 3.3;
  out.continuous_force_N = 0.88;
  out.max_stiffness_N_per_mm = 1.0;
  out.max_damping_N_s_per_m = 5.0;
  out.damping_N_s_per_m = 0.2;
  out.friction_N = 0.26;
  out.resolution_mm = 0.055;
  out.delay_s = 0.001;
  return out;
}

/// Of a hand without motors (a mouse, a pad, a script): what is shown is what an Omni would give whose motors never
/// get warm.
inline DeviceSpecs shownForceFigures() noexcept {
  DeviceSpecs out = phantomOmniFigures();
  out.continuous_force_N = out.max_force_N;
  return out;
}

/// A device's description, known before it is used.
struct DeviceInfo : DeviceSpecs {
  std::string name{};  ///< as the status bar shows it, passed through `tr`: names of our own are in English
  friend bool operator==(const DeviceInfo&, const DeviceInfo&) = default;
};

struct DevicePose {
  PointMm position;           ///< from the middle of workspace_mm
  std::uint32_t buttons = 0;  ///< a bit a button, the first in bit 0
  /// Raised by one when the position jumps because the hand was placed elsewhere; a device in a hand never does so.
  std::uint32_t discontinuities = 0;
  bool fresh = true;  ///< false: nothing new has come from the device since the last read; the position is the last one
  bool connected = true;  ///< false: the device is gone
  bool fault = false;     ///< the device itself reports a fault, or is not calibrated: no force
  float motor_heat = 0;   ///< 0 cold to 1 as warm as its motors may be, where it reports this
  /// The position's age when it is read plus the time that the answering force waits, as the driver measures both on
  /// its own thread; comes on top of DeviceSpecs::delay_s.
  float age_s = 0;
  Quat orientation = kNoRotation;  ///< of what is in the hand, from the device's axes; none where it measures none
};

/// The speed at which a person wants the view to move and to turn, each -1 to 1 along and round the screen's axes (+x
/// right, +y up, +z toward the person). The molecule follows the hand.
struct ViewMotion {
  Vec3 move{0.0}, rotation{0.0};
};

/// A device's state, in words for the person who holds it.
struct DeviceStatus {
  bool connected = true;
  bool ready = true;            ///< false: no force yet, or its positions cannot be trusted; `text` says what to do
  std::string text;             ///< what is wrong, or what the person should do; may be empty
  bool asks_calibrate = false;  ///< waits for calibrate(), to be called when the person has done what `text` says
  double motor_heat = -1.0;  ///< 0 cold to 1 as warm as its motors may be, as the device reports it; -1: not reported
};

/// A device with a clock of its own calls this once a tick, on its own thread.
class ClockListener {
 public:
  virtual void onDeviceTick() noexcept = 0;

 protected:
  ~ClockListener() = default;
};

/// An open device: its driver opens it (driver.h), its destructor gives no force and closes it.
class Device {
 public:
  virtual ~Device() = default;
  virtual const DeviceInfo& info() const noexcept = 0;
  /// The pose now; `dt_s` is the length of a tick.
  virtual DevicePose read(double dt_s) noexcept = 0;
  /// The force to give until the next tick; the caller keeps it finite and within max_force_N.
  virtual void write(ForceN force) noexcept = 0;
  /// The same with a torque. Only a device of dof_out 6 is given the torque; others are given the force alone.
  virtual void writeWrench(const Wrench& wrench) noexcept { write(wrench.force); }
  /// Called in place of write(): no force until the next write, with the motors off where the device can switch them.
  virtual void stop() noexcept { write(ForceN{}); }

  /// The window's thread, a few times a second. May take a while; does the work that must not be done on the haptic
  /// thread.
  virtual DeviceStatus status() { return {}; }
  /// The window's thread, each frame.
  virtual ViewMotion viewMotion() noexcept { return {}; }
  /// The window's thread: whether a rotation on the device rotates the hand from now on instead of the view. A device
  /// that measures the hand's own orientation always rotates the hand.
  virtual void rotateHand(bool) noexcept {}
  /// The window's thread: the person now holds the device as status() asked for its calibration.
  virtual void calibrate() {}

  /// The window's thread. A device whose driver brings a clock calls `target` by it from now on and returns true.
  /// Others return false; then the loop's own clock reads them.
  virtual bool startClock(ClockListener&) { return false; }
  /// The window's thread. After it returns the target is not called any more.
  virtual void stopClock() {}
};

}  // namespace moltact
