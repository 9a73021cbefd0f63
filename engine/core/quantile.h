// Quantiles of values that have been sorted. Pure functions; any thread.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace moltact {

/// By nearest rank: the smallest of the ascending values that at least `fraction` (0 to 1) of them do not exceed. For
/// measurements: the result is always one of them. 0 for no values.
inline double percentile(const std::vector<double>& ascending, double fraction) {
  if (ascending.empty()) return 0.0;
  const auto rank = static_cast<std::size_t>(std::ceil(fraction * double(ascending.size()) - 1e-9));
  return ascending[std::clamp<std::size_t>(rank, 1, ascending.size()) - 1];
}

/// By interpolation between the two values next to that fraction. For the few values of a class, where the median of
/// two lies between them. 0 for no values.
inline double quantile(const std::vector<double>& ascending, double fraction) {
  if (ascending.empty()) return 0.0;
  const double at = std::clamp(fraction, 0.0, 1.0) * double(ascending.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, ascending.size() - 1);
  return ascending[below] + (at - double(below)) * (ascending[above] - ascending[below]);
}

}  // namespace moltact
