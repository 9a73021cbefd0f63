// The motors' heat. A winding warms with the square of its current, which is proportional to the force, and cools with
// the time constant kHeat_s. The peak force is available for a while; when it is held, it falls to the continuous force
// and never brings the heat above the continuous force's. Haptic thread. Units: newton, second.
#pragma once

#include <algorithm>
#include <cmath>

#include "engine/servo/safety_limits.h"

namespace moltact {

class ThermalModel {
 public:
  /// Adds the heat of a force that was held for `dt_s`.
  void add(double force_N, double dt_s) noexcept {
    heat_N2_ += (force_N * force_N - heat_N2_) * std::min(1.0, dt_s / safety::kHeat_s);
  }

  /// The heat that the device itself reports: 0 cold to 1 as warm as its motors may be; non-finite counts as 1.
  void setReportedHeat(double fraction) noexcept { reported_ = std::isfinite(fraction) ? fraction : 1.0; }

  /// The greatest force now, between the continuous and the peak.
  double allowed_N(double peak_N, double continuous_N) const noexcept {
    if (continuous_N >= peak_N) return peak_N;
    const double used_fraction = std::max(used(continuous_N), reported_);
    const double part = std::clamp((1.0 - used_fraction) / (1.0 - safety::kWarm), 0.0, 1.0);
    return continuous_N + (peak_N - continuous_N) * part;
  }

  /// The heat as a fraction of the heat that the continuous force causes permanently: 0 cold, 1 as warm as allowed.
  double used(double continuous_N) const noexcept {
    return continuous_N > 0 ? heat_N2_ / (continuous_N * continuous_N) : 1.0;
  }

 private:
  friend struct StepState;  // step_state.cpp, which keeps it
  double heat_N2_ = 0, reported_ = 0;
};

}  // namespace moltact
