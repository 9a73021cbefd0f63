// Small helps of the tracker tests: scenes from a list, a HIP led along a line, the deepest ball by a plain loop.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "engine/haptics/ball_scene.h"
#include "engine/haptics/tracker.h"

namespace moltact::test {

inline std::shared_ptr<const BallScene> makeScene(std::vector<Ball> balls) {
  return std::make_shared<const BallScene>(std::move(balls));
}

/// How far the place lies inside the ball that holds it deepest (unit: angstrom); negative outside all.
inline double deepest_A(const std::vector<Ball>& balls, double probe_A, const Vec3& place) {
  double deepest = -1e300;
  for (const Ball& b : balls) deepest = std::max(deepest, b.radius_A + probe_A - glm::distance(place, b.centre_A));
  return deepest;
}

/// Leads the HIP along a straight line in steps of at most `step_A` and returns the contact at its end.
inline Contact walkTo(Tracker& tracker, const Vec3& from, const Vec3& to, double step_A) {
  const int steps = std::max(1, static_cast<int>(std::ceil(glm::distance(from, to) / step_A)));
  Contact last;
  for (int k = 0; k <= steps; ++k) last = tracker.step({from + (to - from) * (double(k) / steps)});
  return last;
}

}  // namespace moltact::test
