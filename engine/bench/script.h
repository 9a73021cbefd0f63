// Composes the motion of a stability scene from segments; each entry is one tick. Units: angstrom.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/bench/stability_scenes.h"
#include "engine/core/units.h"

namespace moltact::bench {

class Script {
 public:
  explicit Script(const Vec3& start) { ticks.push_back({start}); }

  /// Straight to `place` in equal steps of at most `step_A`.
  Script& to(const Vec3& place, double step_A = 0.008) {
    const Vec3 from = ticks.back().place_A;
    const int n = std::max(1, static_cast<int>(std::ceil(glm::distance(from, place) / step_A)));
    for (int k = 1; k <= n; ++k) ticks.push_back({from + (place - from) * (double(k) / n)});
    return *this;
  }
  Script& hold(int count) {
    for (int k = 0; k < count; ++k) ticks.push_back({ticks.back().place_A});
    return *this;
  }
  /// Along the circle centre + radius (u cos t + w sin t), from `from` to `to` (unit: whole turns).
  Script& arc(const Vec3& centre, const Vec3& u, const Vec3& w, double radius, double from, double to,
              double step_A = 0.008) {
    const double angle = kTwoPi * (to - from);
    const int n = std::max(1, static_cast<int>(std::ceil(std::abs(angle) * radius / step_A)));
    for (int k = 1; k <= n; ++k) {
      const double t = kTwoPi * from + angle * k / n;
      ticks.push_back({centre + (u * std::cos(t) + w * std::sin(t)) * radius});
    }
    return *this;
  }
  Script& path(const scenes::Path& places) {
    for (const Vec3& p : places) ticks.push_back({p});
    return *this;
  }
  StabilityTick& last() { return ticks.back(); }

  std::vector<StabilityTick> ticks;
};

}  // namespace moltact::bench
