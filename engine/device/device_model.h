// A simulated force-feedback stylus held by a hand, which closes the loop around a method without hardware.
// Deterministic, on a virtual clock, with figures of the Phantom Omni class. Units: millimetre in the interface, SI
// inside; newton, second.
//
//   m x'' = F_held + F_hand - b x' - f_c tanh(|x'| / v_0) x'/|x'|
//   F_hand = k_h (target - x) + b_h (target' - x')
//
// F_held is the command of `delay_ticks` ago, clamped to max_force_N and held for a whole tick (zero-order hold). The
// program reads x rounded to `resolution_mm` on each axis. The fourth-order Runge-Kutta method integrates with
// `substeps` per tick.
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
  int delay_ticks = 1;  ///< 0 to 100
  double tick_s = 0.001;
  int substeps = 10;
};

struct HandParameters {
  double stiffness_N_per_m = 300;
  double damping_N_s_per_m = 5;
};

/// No hand: the device floats freely.
inline constexpr HandParameters kNoHand{0, 0};

class DeviceModel {
 public:
  DeviceModel(const DeviceParameters& device, const HandParameters& hand, PointMm at);

  /// The position as the program reads it.
  PointMm sensed() const;
  PointMm position() const { return {1e3 * x_}; }
  Vec3 velocity_m_per_s() const { return v_; }

  /// Advances by one tick: accepts the program's command (a non-finite one gives no force) and moves the hand linearly
  /// to `target`.
  void tick(ForceN command, PointMm target);

  /// The force held during the last tick (unit: newton).
  ForceN held() const { return {held_}; }

  /// Applies an impulse to the device (unit: N s).
  void strike(const Vec3& impulse_N_s) { v_ += impulse_N_s / device_.mass_kg; }

 private:
  Vec3 acceleration(const Vec3& x, const Vec3& v, const Vec3& target, const Vec3& target_v) const;

  DeviceParameters device_;
  HandParameters hand_;
  Vec3 x_, v_{0.0}, target_, held_{0.0};  // m, m/s, m, N
  std::vector<Vec3> queue_;               // delayed commands
  std::size_t next_ = 0;
};

}  // namespace moltact
