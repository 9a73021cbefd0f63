// The thermal model of the motors. A winding heats with the square of its current, which is proportional to the force,
// and cools with time constant kHeat_s. The peak force is available for a short time. When it is held, the limit falls
// to the continuous force, so that the heat never exceeds that of the continuous force. Haptic thread. Units: newton,
// second.
#pragma once

#include <algorithm>
#include <cmath>

#include "engine/servo/safety_limits.h"

namespace moltact {

class ThermalModel {
 public:
  /// Adds the heat of a force held for `dt_s`.
  void add(double force_N, double dt_s) noexcept {
    heat_N2_ += (force_N * force_N - heat_N2_) * std::min(1.0, dt_s / safety::kHeat_s);
  }

  /// Sets the heat reported by the device: 0 cold to 1 maximum temperature; non-finite counts as 1.
  void setReportedHeat(double fraction) noexcept { reported_ = std::isfinite(fraction) ? fraction : 1.0; }

  /// The present limit on the force, between continuous and peak force.
  double allowed_N(double peak_N, double continuous_N) const noexcept {
    if (continuous_N >= peak_N) return peak_N;
    const double used_fraction = std::max(used(continuous_N), reported_);
    const double part = std::clamp((1.0 - used_fraction) / (1.0 - safety::kWarm), 0.0, 1.0);
    return continuous_N + (peak_N - continuous_N) * part;
  }

  /// The heat relative to the steady-state heat at the continuous force: 0 cold, 1 maximum.
  double used(double continuous_N) const noexcept {
    return continuous_N > 0 ? heat_N2_ / (continuous_N * continuous_N) : 1.0;
  }

 private:
  friend struct StepState;  // step_state.cpp, which saves the state
  double heat_N2_ = 0, reported_ = 0;
};

}  // namespace moltact
