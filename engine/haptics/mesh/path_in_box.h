// The test whether a straight path meets a box, for the search in a tree of triangles. Every thread.
#pragma once

#include <algorithm>

#include "engine/core/units.h"

namespace moltact {

/// Whether the path from `from` to `from + path` meets the box before its fraction `until`. `per_path` is 1 / path; its
/// component is not used where the path's is 0.
inline bool pathMeetsBox(const Vec3& from, const Vec3& path, const Vec3& per_path, const Vec3& low, const Vec3& high,
                         double until) noexcept {
  double t0 = 0.0, t1 = until;
  bool apart = false;
  for (int k = 0; k < 3; ++k) {
    if (path[k] == 0.0) {
      apart = apart || from[k] < low[k] || from[k] > high[k];
      continue;
    }
    const double a = (low[k] - from[k]) * per_path[k], b = (high[k] - from[k]) * per_path[k];
    t0 = std::max(t0, std::min(a, b));
    t1 = std::min(t1, std::max(a, b));
  }
  return !apart && t0 <= t1;
}

}  // namespace moltact
