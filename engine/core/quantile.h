// Quantiles of values that have been sorted. Pure functions; any thread.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace moltact {

/// By nearest rank: the smallest of the ascending values that at least the fraction `fraction` (0 to 1) does not exceed. For
/// measurements, of which it is always one. 0 of none.
inline double percentile(const std::vector<double>& ascending, double fraction) {
  if (ascending.empty()) return 0.0;
  const auto rank = static_cast<std::size_t>(std::ceil(fraction * double(ascending.size()) - 1e-9));
  return ascending[std::clamp<std::size_t>(rank, 1, ascending.size()) - 1];
}

/// By interpolation between the two values about that fraction: for the few values of a class, where the median of two is
/// between them. 0 of none.
inline double quantile(const std::vector<double>& ascending, double fraction) {
  if (ascending.empty()) return 0.0;
  const double at = std::clamp(fraction, 0.0, 1.0) * double(ascending.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, ascending.size() - 1);
  return ascending[below] + (at - double(below)) * (ascending[above] - ascending[below]);
}

}  // namespace moltact
