// Helpers of the tracker tests: scenes from a list, a HIP moved along a line, the deepest sphere by a plain loop.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "engine/haptics/sphere_grid.h"
#include "engine/haptics/tracker.h"

namespace moltact::test {

inline std::shared_ptr<const SphereGrid> makeScene(std::vector<Sphere> spheres) {
  return std::make_shared<const SphereGrid>(std::move(spheres));
}

/// The maximum depth of the place inside any sphere (unit: angstrom); negative outside all.
inline double deepest_A(const std::vector<Sphere>& spheres, double probe_A, const Vec3& place) {
  double deepest = -1e300;
  for (const Sphere& b : spheres) deepest = std::max(deepest, b.radius_A + probe_A - glm::distance(place, b.centre_A));
  return deepest;
}

/// Moves the HIP along a straight line in steps of at most `step_A` and returns the contact at its end.
inline Contact walkTo(Tracker& tracker, const Vec3& from, const Vec3& to, double step_A) {
  const int steps = std::max(1, static_cast<int>(std::ceil(glm::distance(from, to) / step_A)));
  Contact last;
  for (int k = 0; k <= steps; ++k) last = tracker.step({from + (to - from) * (double(k) / steps)});
  return last;
}

}  // namespace moltact::test
