// Checks that every method makes on its input: it refuses a HIP that is no usable place and clamps a probe. Haptic
// thread. Units: angstrom.
#pragma once

#include <algorithm>
#include <cmath>

#include "engine/haptics/tracker.h"

namespace moltact {

/// False for NaN, infinity and places beyond kFarthest_A.
inline bool usableHip(const Vec3& v) {
  return std::abs(v.x) <= kFarthest_A && std::abs(v.y) <= kFarthest_A && std::abs(v.z) <= kFarthest_A;
}

/// The answer to a HIP that is not usable; its SCP is `last` where the HIP is not even finite.
inline Contact refusedHip(PointA hip, const Vec3& last) {
  Contact refused{.scp = hip, .fault = Fault::NotFinite};
  if (!std::isfinite(hip.A.x) || !std::isfinite(hip.A.y) || !std::isfinite(hip.A.z)) refused.scp.A = last;
  return refused;
}

/// A probe radius within 0 to kLargestProbe_A; `otherwise` where it is not finite.
inline double usableProbe_A(double probe_A, double otherwise) {
  return std::isfinite(probe_A) ? std::clamp(probe_A, 0.0, kLargestProbe_A) : otherwise;
}

}  // namespace moltact
