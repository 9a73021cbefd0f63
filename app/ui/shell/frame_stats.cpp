#include "app/ui/shell/frame_stats.h"

#include <algorithm>
#include <cstdio>
#include <numeric>

namespace moltact {

std::string FrameStats::json() const {
  if (frames_ms_.empty()) return "{\"frames\": 0}";
  std::vector<double> sorted = frames_ms_;
  std::sort(sorted.begin(), sorted.end());
  const double mean = std::accumulate(sorted.begin(), sorted.end(), 0.0) / double(sorted.size());
  const auto part = [&](double p) {
    return sorted[std::min(sorted.size() - 1, std::size_t(p * double(sorted.size())))];
  };
  char text[240];
  std::snprintf(text, sizeof text,
                "{\"frames\": %zu, \"mean_ms\": %.2f, \"p50_ms\": %.2f, \"p95_ms\": %.2f, \"max_ms\": %.2f, "
                "\"frames_per_s\": %.1f}",
                sorted.size(), mean, part(0.5), part(0.95), sorted.back(), 1000.0 / mean);
  return text;
}

}  // namespace moltact
