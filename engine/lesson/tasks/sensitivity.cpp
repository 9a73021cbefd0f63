#include "engine/lesson/tasks/sensitivity.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace moltact {

double normalQuantile(double p) {
  p = std::clamp(p, 1e-12, 1.0 - 1e-12);
  // Bisection: 60 steps are exact to rounding, and each task needs it only once.
  double low = -8.0, high = 8.0;
  for (int k = 0; k < 60; ++k) {
    const double z = 0.5 * (low + high);
    (0.5 * std::erfc(-z / std::numbers::sqrt2) < p ? low : high) = z;
  }
  return 0.5 * (low + high);
}

double sensitivity(int hits, int signals, int alarms, int noises) {
  const auto share = [](int count, int all) { return (count + 0.5) / (all + 1.0); };
  return normalQuantile(share(hits, signals)) - normalQuantile(share(alarms, noises));
}

}  // namespace moltact
