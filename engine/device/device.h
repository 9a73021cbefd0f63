// The interface of every haptic device: input is a pose, output a force or a wrench. `read` and `write` run on the
// haptic thread: no lock, allocation, exception, log or wait. Units: millimetre and newton, in the device's space (+x
// right, +y up, +z toward the user). Quat is constructed as (w, x, y, z).
#pragma once

#include <cstdint>
#include <limits>
#include <string>

#include "engine/core/units.h"

namespace moltact {

/// A device's capabilities. A driver sets each figure that it knows. The defaults mean unknown and reduce the force:
/// none at all without both force limits, softer springs without the other figures (engine/servo/safety_stage.h).
struct DeviceSpecs {
  static constexpr double kNoLimit = std::numeric_limits<double>::infinity();
  static constexpr double kUnknownStiffness_N_per_mm = 0.3, kUnknownDelay_s = 0.002, kUnknownResolution_mm = 0.1;

  Vec3 workspace_mm{160.0, 120.0, 70.0};  ///< size of the reachable box, edge to edge
  int dof_in = 3;            ///< degrees of freedom that are read and used: 3 position, 6 position and orientation
  int dof_out = 0;           ///< degrees of freedom that are driven: 0 none, 3 force, 6 force and torque
  double max_force_N = 0.0;  ///< peak force, available for a short time
  double continuous_force_N = 0.0;                             ///< force that the motors sustain thermally
  double max_stiffness_N_per_mm = kUnknownStiffness_N_per_mm;  ///< stiffest wall that it can render
  double max_damping_N_s_per_m = 0.0;                          ///< strongest damping that it can render
  double damping_N_s_per_m = 0.0;                              ///< of the mechanism itself
  double friction_N = 0.0;                                     ///< Coulomb friction of the mechanism; 0: unknown
  double resolution_mm = kUnknownResolution_mm;                ///< resolution of the reported position
  double delay_s = kUnknownDelay_s;        ///< from the encoders to the driver plus from there to the motors
  double speed_limit_m_per_s = kNoLimit;   ///< above this speed of the hand the device gives no force
  double slew_limit_N_per_s = kNoLimit;    ///< the device cuts a force that changes faster
  double max_torque_N_mm = 0.0;            ///< peak torque; 0: no torque
  double rotational_damping_N_mm_s = 0.0;  ///< b_r, of the mechanism about its axes, per radian; 0: not known
  bool gives_force = false;                ///< false: the force is displayed on the screen only

  friend bool operator==(const DeviceSpecs&, const DeviceSpecs&) = default;
};

/// Figures of the Phantom Omni's motors and mechanism, partly published by the vendor, partly measured in the
/// literature; docs/devices.md states the source of each.
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

/// Figures for input devices without motors (a mouse, a pad, a script): the displayed force is that of an Omni whose
/// motors never become warm.
inline DeviceSpecs shownForceFigures() noexcept {
  DeviceSpecs out = phantomOmniFigures();
  out.continuous_force_N = out.max_force_N;
  return out;
}

/// A device's description, known before it is used.
struct DeviceInfo : DeviceSpecs {
  std::string name{};  ///< for the status bar, passed through `tr`; names chosen by this program are in English
  friend bool operator==(const DeviceInfo&, const DeviceInfo&) = default;
};

struct DevicePose {
  PointMm position;           ///< relative to the middle of workspace_mm
  std::uint32_t buttons = 0;  ///< one bit per button, the first in bit 0
  /// Incremented when the position jumps: the program placed the hand elsewhere, or the device was reconnected.
  std::uint32_t discontinuities = 0;
  bool fresh = true;      ///< false: no new data since the last read; the position is the previous one
  bool connected = true;  ///< false: the device is disconnected
  bool fault = false;     ///< the device reports a fault or is not calibrated: no force
  float motor_heat = 0;   ///< 0 cold to 1 maximum temperature, if the device reports it
  /// Age of the position when it is read, plus the time until the resulting force is sent. The driver measures both on
  /// its own thread. Adds to DeviceSpecs::delay_s.
  float age_s = 0;
  Quat orientation = kNoRotation;  ///< of the handle, relative to the device's axes; identity if not measured
};

/// The requested speed of the view's motion and rotation, each component -1 to 1, along and about the screen's axes (+x
/// right, +y up, +z toward the user). The molecule follows the hand.
struct ViewMotion {
  Vec3 move{0.0}, rotation{0.0};
};

/// A device's state, with text for the user.
struct DeviceStatus {
  bool connected = true;
  bool ready = true;            ///< false: no force yet, or the positions are unreliable; `text` gives the remedy
  std::string text;             ///< the problem, or the action required of the user; may be empty
  bool asks_calibrate = false;  ///< the device waits for calibrate(), to be called after the user has followed `text`
  double motor_heat = -1.0;     ///< 0 cold to 1 maximum temperature; -1: not reported
};

/// Receives the ticks of a device with its own clock, on the device's thread.
class ClockListener {
 public:
  virtual void onDeviceTick() noexcept = 0;

 protected:
  ~ClockListener() = default;
};

/// An open device. A driver opens it (driver.h); the destructor ends the force and closes it.
class Device {
 public:
  virtual ~Device() = default;
  virtual const DeviceInfo& info() const noexcept = 0;
  /// Returns the present pose; `dt_s` is the length of a tick.
  virtual DevicePose read(double dt_s) noexcept = 0;
  /// Sets the force until the next tick; the caller keeps it finite and within max_force_N.
  virtual void write(ForceN force) noexcept = 0;
  /// The same with a torque. Only a device with dof_out 6 receives the torque; others receive the force alone.
  virtual void writeWrench(const Wrench& wrench) noexcept { write(wrench.force); }
  /// Called instead of write(): no force until the next write, with the motors off if the device can switch them.
  virtual void stop() noexcept { write(ForceN{}); }

  /// Window's thread, a few times a second. May block; performs work that is not allowed on the haptic thread.
  virtual DeviceStatus status() { return {}; }
  /// Window's thread, each frame.
  virtual ViewMotion viewMotion() noexcept { return {}; }
  /// Window's thread: selects whether a rotation of the device rotates the hand or the view. A device that measures the
  /// hand's orientation always rotates the hand.
  virtual void rotateHand(bool) noexcept {}
  /// Window's thread: the user now holds the device as status() requested for the calibration.
  virtual void calibrate() {}

  /// Window's thread. A device with its own clock calls `target` at each tick from now on and returns true. Other
  /// devices return false, and the loop's own clock reads them.
  virtual bool startClock(ClockListener&) { return false; }
  /// Window's thread. After its return the listener is no longer called.
  virtual void stopClock() {}
};

}  // namespace moltact
