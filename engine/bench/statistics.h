// Statistics of a list of measurements: mean, percentiles, extremes. Not for the haptic thread.
#pragma once

#include <cstddef>
#include <vector>

namespace moltact::bench {

/// In the unit of the values. Percentiles by nearest rank: p99 is the smallest value that at least 99 % of the values
/// do not exceed.
struct Statistics {
  std::size_t count = 0;
  double mean = 0, rms = 0, p50 = 0, p99 = 0, p9999 = 0, max = 0;
};

/// All zeros for no values. The values must not be NaN.
Statistics statisticsOf(std::vector<double> values);

/// A mean and its uncertainty: half the width of the 95 % interval by Student's t; 0 for fewer than two values.
struct MeanOf {
  double mean = 0, half_width = 0;
};
MeanOf meanOf(const std::vector<double>& values);

/// The Pareto front of the points (cost, error): the points that no other beats in both, as indices by ascending cost.
/// Of equal points the first counts.
std::vector<std::size_t> paretoFront(const std::vector<double>& cost, const std::vector<double>& error);

}  // namespace moltact::bench
