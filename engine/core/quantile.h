// Quantiles of sorted values. Pure functions; any thread.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace moltact {

/// The nearest-rank percentile: the smallest value that is not exceeded by at least `fraction` (0 to 1) of the
/// ascending values. Used for measurements, because the result is one of them. Returns 0 without values.
inline double percentile(const std::vector<double>& ascending, double fraction) {
  if (ascending.empty()) return 0.0;
  const auto rank = static_cast<std::size_t>(std::ceil(fraction * double(ascending.size()) - 1e-9));
  return ascending[std::clamp<std::size_t>(rank, 1, ascending.size()) - 1];
}

/// The quantile by linear interpolation between the two adjacent values. Used for the few values of a class, where the
/// median of two lies between them. Returns 0 without values.
inline double quantile(const std::vector<double>& ascending, double fraction) {
  if (ascending.empty()) return 0.0;
  const double at = std::clamp(fraction, 0.0, 1.0) * double(ascending.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, ascending.size() - 1);
  return ascending[below] + (at - double(below)) * (ascending[above] - ascending[below]);
}

}  // namespace moltact
