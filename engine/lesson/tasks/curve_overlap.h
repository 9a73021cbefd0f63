// How far a drawn curve and a felt one agree. Any thread.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace moltact {

/// The area under both curves, as a share of the area under at least one of them, where both are finite; 1 if neither has
/// an area. Both have the same length and no negative value.
inline double curveOverlap(const std::vector<double>& a, const std::vector<double>& b) {
  double common = 0.0, either = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (!std::isfinite(a[k]) || !std::isfinite(b[k])) continue;
    common += std::min(a[k], b[k]);
    either += std::max(a[k], b[k]);
  }
  return either > 0.0 ? common / either : 1.0;
}

}  // namespace moltact
