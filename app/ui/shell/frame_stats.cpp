#include "app/ui/shell/frame_stats.h"

#include <algorithm>
#include <cstdio>
#include <numeric>

#include "engine/core/quantile.h"

namespace moltact {

std::string FrameStats::json() const {
  if (frames_ms_.empty()) return "{\"frames\": 0}";
  std::vector<double> sorted = frames_ms_;
  std::sort(sorted.begin(), sorted.end());
  const double mean = std::accumulate(sorted.begin(), sorted.end(), 0.0) / double(sorted.size());
  char text[240];
  std::snprintf(text, sizeof text,
                "{\"frames\": %zu, \"mean_ms\": %.2f, \"p50_ms\": %.2f, \"p95_ms\": %.2f, \"max_ms\": %.2f, "
                "\"frames_per_s\": %.1f}",
                sorted.size(), mean, percentile(sorted, 0.5), percentile(sorted, 0.95), sorted.back(), 1000.0 / mean);
  return text;
}

}  // namespace moltact
