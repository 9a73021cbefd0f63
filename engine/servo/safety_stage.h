// The stage between a method's force and a hand: the same for every device, always on. A function of its state and its
// inputs, on the clock that it is given. Haptic thread: no lock, allocation, exception, log or call of the system.
// docs/safety.md says what each limit is and why. Units: millimetre, newton, second.
#pragma once

#include <cmath>

#include "engine/device/device.h"
#include "engine/servo/hand_speed.h"
#include "engine/servo/passivity_control.h"
#include "engine/servo/safety_limits.h"
#include "engine/servo/thermal_model.h"

namespace moltact {

/// The time since the last tick, and how long the answer takes.
struct TickTime {
  double dt_s = kTick_s;  ///< since the tick before; negative, NaN or over kStale_s is a fault
  double delay_s = 0.0;   ///< from reading the place to writing the force, as last measured
};

/// The force, torque and stored energy of springs of one stiffness, each divided by that stiffness; zero without
/// contact.
struct Springs {
  double stretch_mm = 0.0;  ///< the force
  double torque_mm2 = 0.0;  ///< the torque
  double energy_mm2 = 0.0;  ///< the stored energy; stretch^2 / 2 for a single spring
  bool none() const { return stretch_mm == 0.0 && torque_mm2 == 0.0 && energy_mm2 == 0.0; }
  bool finite() const { return std::isfinite(stretch_mm) && std::isfinite(torque_mm2) && std::isfinite(energy_mm2); }
};

/// What holds the energy that is felt: springs of one stiffness, and a field that no stiffness scales.
struct Stored {
  Springs springs{};
  bool field = false;                       ///< a field acts; else the members below are not used
  double field_energy_N_mm = 0.0;           ///< its potential energy
  double field_stiffness_N_per_mm = 0.0;    ///< no small step of the hand is opposed by more
  double force_N = 0.0, torque_N_mm = 0.0;  ///< the size of what springs and field gave together, before every limit

  bool finite() const {
    return springs.finite() && std::isfinite(field_energy_N_mm) && std::isfinite(field_stiffness_N_per_mm) &&
           std::isfinite(force_N) && std::isfinite(torque_N_mm);
  }
};

/// The stiffness of what is felt at the last pose, with springs and field apart.
struct LocalStiffness {
  double springs = 1.0;         ///< so many springs act together along the stiffest direction
  double rotational_mm2 = 0.0;  ///< of the springs round the stiffest axis, over the stiffness of one
  bool field = false;           ///< a field acts; else the members below are not used
  double field_N_per_mm = 0.0;  ///< of the field along its stiffest direction
  double field_rotational_N_mm = 0.0;
};

/// The force and torque that an interaction wants the hand to feel.
struct WantedWrench {
  Vec3 force_N{0.0};
  Vec3 torque_N_mm{0.0};  ///< about the hand's position
  Stored stored{};        ///< behind both
  /// Where the surface itself moved: the same with the hand still at its last position. This separates the energy
  /// that the surface's motion stores from the energy that the hand's motion stores.
  const Stored* before = nullptr;
  double stiffness_N_per_mm = 0.0;  ///< of the springs that give it
  double most_N = 3.3;              ///< the greatest force that the program allows
  bool on = true;                   ///< false: no force is wanted, and the next begins softly
};

class SafetyStage {
 public:
  /// Takes a device's figures. The force of the next ticks starts softly.
  explicit SafetyStage(const DeviceSpecs& device) noexcept { setDevice(device); }
  void setDevice(const DeviceSpecs& device) noexcept;

  /// Call first in a tick, with the position as read. True: the old contact is void, because the position jumped, the
  /// device was gone, or nothing was known of it for kContactLost_s; the interaction must be reset.
  bool beginTick(const DevicePose& pose, const TickTime& time) noexcept;

  /// The stiffness to use for the one that is asked (unit: N/mm) of each of the springs that act together: bounded so
  /// that the loop is stable with all of them and the field, and changed slowly; but where more come to act together
  /// than the bound allows, each is softer at once. Non-finite gives zero.
  double stiffness(double asked_N_per_mm, const LocalStiffness& felt = {}) noexcept;
  double stiffnessInForce_N_per_mm() const noexcept { return stiffness_; }  ///< as stiffness() gave it last
  /// The share of the field's force and torque that the loop bears, 0 to 1, after stiffness(): a field that is stiffer
  /// than kFieldShare of the bound is scaled down.
  double fieldShare() const noexcept { return field_share_; }

  /// Call last in a tick: the force and the torque to give. The torque is zero for a device that drives none. Always
  /// finite and within the device's greatest; zero in a tick with a fault. The stage does not know what is felt: power
  /// is force times velocity plus torque times angular velocity.
  Wrench output(const WantedWrench& wanted) noexcept;

  /// For a new interaction, a hand that was placed elsewhere, or a fault of the interaction: the force starts softly
  /// from zero.
  void restart() noexcept { gain_ = 0.0; }
  /// Panic: no force at all from this tick on, without a ramp, until false again.
  void stop(bool stopped) noexcept { stopped_ = stopped; }

  LimitFlags acted() const noexcept { return acted_; }                ///< in this tick
  double debt_J() const noexcept { return passivity_.debt_J(); }      ///< energy made and not yet taken back
  double stiffnessBound_N_per_mm() const noexcept;                    ///< with the recently measured delay
  double heat() const noexcept { return heat_.used(continuous_N_); }  ///< 0 cold, 1 as warm as the motors may be

 private:
  friend struct StepState;  // step_state.cpp, which keeps it
  double allowed_N(double most_N) const noexcept;
  double cutFraction(double force_N, double torque_N_mm, double most_N) const noexcept;
  double stored_J(const Springs& springs, double stiffness_N_per_mm, double most_N) const noexcept;
  double fieldRise_J(const Stored& from, const Stored& to, double stiffness_N_per_mm, double most_N) const noexcept;
  double sharedBound_N_per_mm(const LocalStiffness& felt) noexcept;
  double greatestField_N_per_mm() const noexcept;
  double rotationalBound_N_mm() const noexcept;
  Vec3 slowed(Vec3 force) noexcept;
  Vec3 slowedTorque(Vec3 torque) noexcept;
  Vec3 braked(Vec3 force, const Vec3& torque, const WantedWrench& wanted, bool begins) noexcept;
  Vec3 brakedTorque(Vec3 torque) noexcept;
  bool drivesTorque() const noexcept { return peak_torque_N_mm_ > 0.0; }
  Vec3 slewed(const Vec3& from, const Vec3& to, double rise, double fall) noexcept;

  // The device's figures.
  double peak_N_ = 0, continuous_N_ = 0, max_stiffness_ = 0, max_damping_ = 0, damping_ = 0, friction_N_ = 0;
  double resolution_m_ = 0, device_delay_s_ = 0, fastest_m_per_s_ = 0, rise_N_per_s_ = 0;
  double peak_torque_N_mm_ = 0;  // 0: it drives none
  bool closes_loop_ = false;

  // State of the hand.
  HandSpeed speed_, angular_speed_;  // of the place; of the angle, in rad/s
  Vec3 place_mm_{0.0}, moved_m_{0.0};
  Quat orientation_ = kNoRotation;
  Vec3 angle_rad_{0.0}, rotation_rad_{0.0};  // the whole rotation so far, and that of the last tick
  bool placed_ = false;                      // place_mm_ holds a place
  std::uint32_t discontinuities_ = 0;
  double stale_s_ = 0, delay_s_ = 0;
  double elapsed_s_ = kTick_s, dt_s_ = kTick_s;  // since the last tick; the same, but never more than a tick
  bool off_ = false;                             // nothing has been known of the hand for kContactLost_s, or it is gone

  // Output.
  ThermalModel heat_;
  PassivityControl passivity_;
  double gain_ = 0, stiffness_ = 0, field_share_ = 1;
  Stored stored_;
  bool fault_ = false, stopped_ = false;
  Vec3 force_N_{0.0}, torque_N_mm_{0.0};  // the torque as wanted where the device drives none
  LimitFlags acted_;
};

/// The stiffness that results for the one that is asked, with the delay of the device's published figures (unit: N/mm).
double steadyStiffness_N_per_mm(double asked_N_per_mm, const DeviceSpecs& device) noexcept;

}  // namespace moltact
