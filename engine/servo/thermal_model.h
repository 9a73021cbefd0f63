// The motors' heat: a winding warms with the square of its current, which is the square of the force, and cools with
// the time constant kHeat_s. Peak force is free for a while; held, it falls to the continuous force and never brings
// the heat above what that force brings for good. Haptic thread. Units: newton, second.
#pragma once

#include <algorithm>
#include <cmath>

#include "engine/servo/safety_limits.h"

namespace moltact {

class ThermalModel {
 public:
  /// The force that was held for `dt_s`.
  void add(double force_N, double dt_s) noexcept {
    heat_N2_ += (force_N * force_N - heat_N2_) * std::min(1.0, dt_s / safety::kHeat_s);
  }

  /// What the device itself tells of its motors: 0 cold to 1 as warm as they may be.
  void setReportedHeat(double fraction) noexcept { reported_ = std::isfinite(fraction) ? fraction : 1.0; }

  /// The greatest force now, between the continuous and the peak.
  double allowed_N(double peak_N, double continuous_N) const noexcept {
    if (continuous_N >= peak_N) return peak_N;
    const double used_fraction = std::max(used(continuous_N), reported_);
    const double part = std::clamp((1.0 - used_fraction) / (1.0 - safety::kWarm), 0.0, 1.0);
    return continuous_N + (peak_N - continuous_N) * part;
  }

  /// Of the heat that the continuous force brings for good: 0 cold, 1 as warm as it may be.
  double used(double continuous_N) const noexcept {
    return continuous_N > 0 ? heat_N2_ / (continuous_N * continuous_N) : 1.0;
  }

 private:
  friend struct StepState;  // step_state.cpp, which keeps it
  double heat_N2_ = 0, reported_ = 0;
};

}  // namespace moltact
