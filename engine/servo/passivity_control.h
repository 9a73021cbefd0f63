// Passivity observer and controller (Hannaford & Ryu 2002), with the energy stored in the spring as reference: a
// passive surface returns no more energy than it has received. The excess that sampling, delay or jumps of a method
// create is the debt. The device's own damping and friction dissipate part of it; braking dissipates the rest. Haptic
// thread. Units: joule, metre, newton, radian, second; torques in newton millimetre.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

#include "engine/core/units.h"
#include "engine/servo/safety_limits.h"

namespace moltact {

class PassivityControl {
 public:
  /// Longest delay: 100 ms of the device and 100 ms measured by the loop, which accepts no more, with a margin.
  static constexpr std::size_t kMaxDelay_ticks = 255;

  void restart() noexcept {
    debt_J_ = 0;
    given_.fill(Vec3(0.0));
    torques_.fill(Vec3(0.0));
  }

  /// Observes the last interval: displacement, rotation, increase of the springs' stored energy, and energy dissipated
  /// by the device itself. `delay_ticks`: time from writing a force to its effect, at most kMaxDelay_ticks.
  void observe(const Vec3& moved_m, const Vec3& turned_rad, double stored_J, double taken_J,
               std::size_t delay_ticks) noexcept {
    const std::size_t back = std::min(delay_ticks, given_.size() - 1);
    const std::size_t held = (next_ + given_.size() - 1 - back) % given_.size();
    const double worked_J = glm::dot(given_[held], moved_m) + 1e-3 * glm::dot(torques_[held], turned_rad);
    debt_J_ = std::max(0.0, debt_J_ + stored_J + worked_J - taken_J);
  }

  /// The braking force that dissipates the debt within a tick, limited by the damping `most_N_s_per_m`.
  Vec3 braking_N(const Vec3& speed_m_per_s, double dt_s, double max_damping_N_s_per_m) const noexcept {
    const double v2 = glm::dot(speed_m_per_s, speed_m_per_s);
    if (debt_J_ <= 0 || dt_s <= 0 || v2 < safety::kStillHand_m_per_s * safety::kStillHand_m_per_s) return Vec3(0.0);
    return -speed_m_per_s * std::min(debt_J_ / (v2 * dt_s), max_damping_N_s_per_m);
  }

  /// The same for rotation: a torque (unit: N mm, damping in N mm s).
  Vec3 braking_N_mm(const Vec3& speed_rad_per_s, double dt_s, double max_damping_N_mm_s) const noexcept {
    const double w2 = glm::dot(speed_rad_per_s, speed_rad_per_s);
    if (debt_J_ <= 0 || dt_s <= 0 || w2 < safety::kStillHand_rad_per_s * safety::kStillHand_rad_per_s) return Vec3(0.0);
    return -speed_rad_per_s * std::min(1e3 * debt_J_ / (w2 * dt_s), max_damping_N_mm_s);
  }

  /// Records the force and torque given at the end of the tick.
  void give(const Vec3& force_N, const Vec3& torque_N_mm) noexcept {
    given_[next_] = force_N;
    torques_[next_] = torque_N_mm;
    next_ = (next_ + 1) % given_.size();
  }

  double debt_J() const noexcept { return debt_J_; }

 private:
  friend struct StepState;                                     // step_state.cpp, which saves the state
  std::array<Vec3, kMaxDelay_ticks + 1> given_{}, torques_{};  // N; N mm
  std::size_t next_ = 0;
  double debt_J_ = 0;
};

}  // namespace moltact
