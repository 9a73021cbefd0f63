#include "engine/haptics/surface_properties.h"

#include <algorithm>
#include <cmath>

namespace moltact {

SurfaceProperties surfaceTowards(const SurfaceProperties& now, const SurfaceProperties& goal, double dt_s) noexcept {
  SurfaceProperties out = now;
  if (goal.friction != now.friction && std::isfinite(goal.friction.coefficient)) {
    const double limit = kFrictionSlew_per_s * dt_s, from = now.friction.coefficient;
    const double to = std::clamp(goal.friction.coefficient, 0.0, kMaxFriction);
    out.friction = {std::abs(to - from) <= limit ? to : from + std::copysign(limit, to - from),
                    goal.friction.stick_slip};
  }
  return out;
}

}  // namespace moltact
