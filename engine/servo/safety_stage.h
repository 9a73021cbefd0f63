// The safety stage between a method's force and the hand: the same for every device, always on. Its output is a
// function of state, inputs and the given time. Haptic thread: no lock, allocation, exception, log or system call.
// docs/safety.md explains each limit. Units: millimetre, newton, second.
#pragma once

#include <cmath>

#include "engine/device/device.h"
#include "engine/servo/hand_speed.h"
#include "engine/servo/passivity_control.h"
#include "engine/servo/safety_limits.h"
#include "engine/servo/thermal_model.h"

namespace moltact {

/// The timing of a tick.
struct TickTime {
  double dt_s = kTick_s;  ///< since the previous tick; negative, NaN or more than kStale_s is a fault
  double delay_s = 0.0;   ///< from reading the position to writing the force, as last measured
};

/// Sizes of force, torque and stored energy of springs of equal stiffness, each divided by the stiffness; zero without
/// contact.
struct Springs {
  double stretch_mm = 0.0;  ///< force / stiffness
  double torque_mm2 = 0.0;  ///< torque / stiffness
  double energy_mm2 = 0.0;  ///< stored energy / stiffness; stretch^2 / 2 for a single spring
  bool none() const { return stretch_mm == 0.0 && torque_mm2 == 0.0 && energy_mm2 == 0.0; }
  bool finite() const { return std::isfinite(stretch_mm) && std::isfinite(torque_mm2) && std::isfinite(energy_mm2); }
};

/// The stored energy behind a wrench: springs of equal stiffness, and a field that is independent of the stiffness.
struct Stored {
  Springs springs{};
  bool field = false;                       ///< a field acts; else the members below are unused
  double field_energy_N_mm = 0.0;           ///< potential energy of the field
  double field_stiffness_N_per_mm = 0.0;    ///< upper bound of the field's stiffness
  double force_N = 0.0, torque_N_mm = 0.0;  ///< sizes of the combined force and torque before all limits

  bool finite() const {
    return springs.finite() && std::isfinite(field_energy_N_mm) && std::isfinite(field_stiffness_N_per_mm) &&
           std::isfinite(force_N) && std::isfinite(torque_N_mm);
  }
};

/// The stiffness at the last pose, with springs and field separate.
struct LocalStiffness {
  double stiffness_factor = 1.0;  ///< combined springs along the stiffest direction, as a multiple of one
  double rotational_mm2 = 0.0;    ///< rotational stiffness of the springs about the stiffest axis / stiffness of one
  bool field = false;             ///< a field acts; else the members below are unused
  double field_N_per_mm = 0.0;    ///< of the field along its stiffest direction
  double field_rotational_N_mm = 0.0;
};

/// The force and torque requested by an interaction.
struct WantedWrench {
  Vec3 force_N{0.0};
  Vec3 torque_N_mm{0.0};  ///< about the hand's position
  Stored stored{};        ///< the energy behind both
  /// Set if the surface itself has moved: the state after its motion, with the hand still at the previous pose. It
  /// separates the energy stored by the surface's motion from that stored by the hand's motion.
  const Stored* before = nullptr;
  double stiffness_N_per_mm = 0.0;  ///< of each spring
  double max_N = 3.3;               ///< the program's limit on the force
  bool on = true;                   ///< false: no force is requested, and the next one starts softly
};

class SafetyStage {
 public:
  /// Sets a device's figures. The force starts softly.
  explicit SafetyStage(const DeviceSpecs& device) noexcept { setDevice(device); }
  void setDevice(const DeviceSpecs& device) noexcept;

  /// Call first in a tick, with the pose as read. Returns true if the interaction must be reset because its contact is
  /// void: the position jumped, the device was disconnected, or it delivered no data for kContactLost_s.
  bool beginTick(const DevicePose& pose, const TickTime& time) noexcept;

  /// Returns the stiffness of each spring (unit: N/mm) for the requested one. It is bounded so that the loop is stable
  /// with all springs and the field together, and it changes slowly. If additional springs exceed the bound, it is
  /// reduced at once. A non-finite request gives zero.
  double stiffness(double asked_N_per_mm, const LocalStiffness& felt = {}) noexcept;
  double stiffnessInForce_N_per_mm() const noexcept { return stiffness_; }  ///< the last result of stiffness()
  /// The usable fraction of the field's force and torque, 0 to 1. Call after stiffness(). A field stiffer than
  /// kFieldShare of the bound is scaled down.
  double fieldShare() const noexcept { return field_share_; }

  /// Call last in a tick. Returns the force and torque to give. The torque is zero for a device without torque. The
  /// result is always finite and within the device's limits, and zero in a tick with a fault. The stage needs no
  /// knowledge of the interaction: power is force times velocity plus torque times angular velocity.
  Wrench output(const WantedWrench& wanted) noexcept;

  /// Restarts the force softly from zero, for a new interaction, a hand placed elsewhere, or a fault of the
  /// interaction.
  void restart() noexcept { gain_ = 0.0; }
  /// Panic stop: zero force from this tick on, without a ramp, until called with false.
  void stop(bool stopped) noexcept { stopped_ = stopped; }

  LimitFlags acted() const noexcept { return acted_; }            ///< limits that acted in this tick
  double debt_J() const noexcept { return passivity_.debt_J(); }  ///< generated energy that is not dissipated yet
  double stiffnessBound_N_per_mm() const noexcept;                ///< with the recently measured delay
  /// The bound of the rotational stiffness that a driven torque shows (unit: N mm per radian). It is the stiffness bound
  /// at the end of the lever on which the peak force gives the peak torque. Where the device's rotational damping is
  /// known, its bound applies too, if lower. 0: not known, because the device drives no torque.
  double rotationalBound_N_mm() const noexcept;
  double heat() const noexcept { return heat_.used(continuous_N_); }  ///< 0 cold, 1 maximum temperature

 private:
  friend struct StepState;  // step_state.cpp, which saves the state
  double allowed_N(double max_N) const noexcept;
  double cutFraction(double force_N, double torque_N_mm, double max_N) const noexcept;
  double stored_J(const Springs& springs, double stiffness_N_per_mm, double max_N) const noexcept;
  double fieldRise_J(const Stored& from, const Stored& to, double stiffness_N_per_mm, double max_N) const noexcept;
  double sharedBound_N_per_mm(const LocalStiffness& felt) noexcept;
  double maxField_N_per_mm() const noexcept;
  Vec3 slowed(Vec3 force) noexcept;
  Vec3 slowedTorque(Vec3 torque) noexcept;
  Vec3 braked(Vec3 force, const Vec3& torque, const WantedWrench& wanted, bool begins) noexcept;
  Vec3 brakedTorque(Vec3 torque) noexcept;
  bool drivesTorque() const noexcept { return peak_torque_N_mm_ > 0.0; }
  Vec3 slewed(const Vec3& from, const Vec3& to, double rise, double fall) noexcept;

  // The device's figures.
  double peak_N_ = 0, continuous_N_ = 0, max_stiffness_ = 0, max_damping_ = 0, damping_ = 0, friction_N_ = 0;
  double resolution_m_ = 0, device_delay_s_ = 0, max_speed_m_per_s_ = 0, rise_N_per_s_ = 0;
  double peak_torque_N_mm_ = 0;           // 0: no torque
  double rotational_damping_N_mm_s_ = 0;  // 0: not known
  bool closes_loop_ = false;

  // State of the hand.
  HandSpeed speed_, angular_speed_;  // from positions; from angles, in rad/s
  Vec3 place_mm_{0.0}, moved_m_{0.0};
  Quat orientation_ = kNoRotation;
  Vec3 angle_rad_{0.0}, rotation_rad_{0.0};  // total rotation so far, and that of the last tick
  bool placed_ = false;                      // place_mm_ is valid
  std::uint32_t discontinuities_ = 0;
  double stale_s_ = 0, delay_s_ = 0;
  double elapsed_s_ = kTick_s, dt_s_ = kTick_s;  // time since the last tick; the same, limited to one tick
  bool off_ = false;                             // no data for kContactLost_s, or disconnected

  // Output.
  ThermalModel heat_;
  PassivityControl passivity_;
  double gain_ = 0, stiffness_ = 0, field_share_ = 1;
  Stored stored_;
  bool fault_ = false, stopped_ = false;
  Vec3 force_N_{0.0}, torque_N_mm_{0.0};  // last output; for a device without torque the requested torque
  LimitFlags acted_;
};

/// The stationary stiffness for a requested one, with the delay of the device's published figures (unit: N/mm).
double steadyStiffness_N_per_mm(double asked_N_per_mm, const DeviceSpecs& device) noexcept;

/// The lever L of the rotational spring of a held body, k_r = k L^2 (unit: angstrom). It is the body's radius of
/// gyration, or less where the device could not show the rotational stiffness K (L / A_per_mm)^2 of a spring of K.
/// Where the bound is not known, because the device drives no torque, it is the radius of gyration.
double springLever_A(double gyration_A, double A_per_mm, double asked_N_per_mm, const DeviceSpecs& device) noexcept;

}  // namespace moltact
