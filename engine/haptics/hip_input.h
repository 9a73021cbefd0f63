// Input checks shared by all methods: an unusable HIP is rejected and the probe radius is clamped. Haptic thread.
// Units: angstrom.
#pragma once

#include <algorithm>
#include <cmath>

#include "engine/haptics/tracker.h"

namespace moltact {

/// False for NaN, infinity and coordinates beyond kMaxPosition_A.
inline bool usableHip(const Vec3& v) {
  return std::abs(v.x) <= kMaxPosition_A && std::abs(v.y) <= kMaxPosition_A && std::abs(v.z) <= kMaxPosition_A;
}

/// The result for an unusable HIP. Its SCP is `last` if the HIP is not finite.
inline Contact refusedHip(PointA hip, const Vec3& last) {
  Contact refused{.scp = hip, .fault = Fault::NotFinite};
  if (!std::isfinite(hip.A.x) || !std::isfinite(hip.A.y) || !std::isfinite(hip.A.z)) refused.scp.A = last;
  return refused;
}

/// Clamps the probe radius to 0 to kMaxProbe_A; returns `otherwise` if it is not finite.
inline double usableProbe_A(double probe_A, double otherwise) {
  return std::isfinite(probe_A) ? std::clamp(probe_A, 0.0, kMaxProbe_A) : otherwise;
}

}  // namespace moltact
