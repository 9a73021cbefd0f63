// A simulated force-feedback stylus held by a hand, which closes the loop around a method without hardware.
// Deterministic, on a virtual clock, with figures of the Phantom Omni class. Units: millimetre in the interface, SI
// inside; newton, second.
//
//   m x'' = F_held + F_hand - b x' - f_c tanh(|x'| / v_0) x'/|x'|
//   F_hand = k_h (target - x) + b_h (target' - x')
//   I w' = M_held + M_hand - b_r w,   M_hand = k_t log(q_target q^-1) + b_t (w_target - w)
//
// F_held and M_held are the command of `delay_ticks` ago, clamped to max_force_N and max_torque_N_mm and held for a whole
// tick (zero-order hold). The handle's inertia I is the same about every axis. The program reads x rounded to
// `resolution_mm` on each axis, and the orientation q as it is. The fourth-order Runge-Kutta method integrates with
// `substeps` per tick, the orientation by the method of Munthe-Kaas.
#pragma once

#include <vector>

#include "engine/core/units.h"

namespace moltact {

struct DeviceParameters {
  double mass_kg = 0.045;
  double damping_N_s_per_m = 0.2;
  double friction_N = 0.26;              ///< f_c
  double friction_speed_m_per_s = 0.01;  ///< v_0: from about twice this speed friction has its full value
  double resolution_mm = 0.055;          ///< 0: no rounding
  double max_force_N = 3.3;
  double inertia_kg_m2 = 5e-5;             ///< I
  double rotational_damping_N_mm_s = 1.0;  ///< b_r, per radian
  double max_torque_N_mm = 170.0;
  int delay_ticks = 1;  ///< 0 to 100
  double tick_s = 0.001;
  int substeps = 10;
};

struct HandParameters {
  double stiffness_N_per_m = 300;
  double damping_N_s_per_m = 5;
  double turn_stiffness_N_mm = 500;  ///< k_t, of the wrist, per radian
  double turn_damping_N_mm_s = 5;    ///< b_t
};

/// No hand: the device floats freely.
inline constexpr HandParameters kNoHand{0, 0, 0, 0};

class DeviceModel {
 public:
  DeviceModel(const DeviceParameters& device, const HandParameters& hand, PointMm at,
              const Quat& orientation = kNoRotation);

  /// The position as the program reads it.
  PointMm sensed() const;
  PointMm position() const { return {1e3 * x_}; }
  Vec3 velocity_m_per_s() const { return v_; }

  Quat orientation() const { return q_; }
  Vec3 turning_rad_per_s() const { return w_; }  ///< in the device's axes

  /// Advances by one tick: accepts the program's command (a non-finite force or torque counts as none) and moves the hand
  /// linearly to `target` and turns its wrist to `orientation`.
  void tick(const Wrench& command, PointMm target, const Quat& orientation);
  /// The same without torque, the wrist at rest.
  void tick(ForceN command, PointMm target) { tick({command, Vec3(0.0)}, target, wrist_); }

  /// The force and the torque held during the last tick.
  ForceN held() const { return {held_}; }
  Vec3 heldTorque_N_mm() const { return 1e3 * held_turn_; }

  /// Applies an impulse to the device (unit: N s), and one about its axes (unit: N mm s).
  void strike(const Vec3& impulse_N_s, const Vec3& turn_N_mm_s = Vec3(0.0)) {
    v_ += impulse_N_s / device_.mass_kg;
    w_ += 1e-3 * turn_N_mm_s / device_.inertia_kg_m2;
  }

 private:
  struct Command {
    Vec3 force{0.0}, torque{0.0};  // N, N m
  };
  Vec3 acceleration(const Vec3& x, const Vec3& v, const Vec3& target, const Vec3& target_v) const;
  Vec3 angularAcceleration(const Quat& q, const Vec3& w, const Quat& wrist, const Vec3& wrist_w) const;
  void moveOn(const Vec3& target);
  void turnOn(const Quat& wrist);

  DeviceParameters device_;
  HandParameters hand_;
  Vec3 x_, v_{0.0}, target_, held_{0.0};  // m, m/s, m, N
  Quat q_, wrist_;                        // of the handle, and where the wrist holds it
  Vec3 w_{0.0}, held_turn_{0.0};          // rad/s, N m
  std::vector<Command> queue_;            // delayed commands
  std::size_t next_ = 0;
};

}  // namespace moltact
