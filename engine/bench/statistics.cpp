#include "engine/bench/statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace moltact::bench {

double percentile(const std::vector<double>& ascending, double share) {
  if (ascending.empty()) return 0;
  const auto rank = static_cast<std::size_t>(std::ceil(share * double(ascending.size()) - 1e-9));
  return ascending[std::clamp<std::size_t>(rank, 1, ascending.size()) - 1];
}

Spread spreadOf(std::vector<double> values) {
  Spread s;
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
