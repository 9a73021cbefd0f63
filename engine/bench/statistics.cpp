#include "engine/bench/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "engine/core/quantile.h"

namespace moltact::bench {

Statistics statisticsOf(std::vector<double> values) {
  Statistics s;
  s.count = values.size();
  if (values.empty()) return s;
  std::sort(values.begin(), values.end());
  double sum = 0, squares = 0;
  for (const double v : values) sum += v, squares += v * v;
  s.mean = sum / double(s.count);
  s.rms = std::sqrt(squares / double(s.count));
  s.p50 = percentile(values, 0.5);
  s.p99 = percentile(values, 0.99);
  s.p9999 = percentile(values, 0.9999);
  s.max = values.back();
  return s;
}

MeanOf meanOf(const std::vector<double>& values) {
  const double n = double(values.size());
  if (values.empty()) return {};
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  if (values.size() < 2) return {mean, 0};
  double squares = 0;
  for (const double v : values) squares += (v - mean) * (v - mean);
  // The 97.5 % point of Student's t by degrees of freedom; beyond the table the expansion is accurate to 0.003.
  static constexpr double kT[] = {12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228};
  const double freedom = n - 1,
               t = freedom <= 10 ? kT[values.size() - 2] : 1.95996 + 2.3723 / freedom + 2.8225 / (freedom * freedom);
  return {mean, t * std::sqrt(squares / freedom / n)};
}

std::vector<std::size_t> paretoFront(const std::vector<double>& cost, const std::vector<double>& error) {
  std::vector<std::size_t> order(cost.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return cost[a] != cost[b] ? cost[a] < cost[b] : error[a] < error[b];
  });
  std::vector<std::size_t> front;
  double best = std::numeric_limits<double>::infinity();
  for (const std::size_t k : order)
    if (error[k] < best) {
      best = error[k];
      front.push_back(k);
    }
  return front;
}

}  // namespace moltact::bench
