// Tick times with cold caches, as in real use: ticks in contact as the haptic thread runs them, one a millisecond with
// sleep between, and ticks after other work has filled the caches. Single ticks, timed by the clock; methods take
// turns. Runs on the calling thread. Units: nanosecond.
#pragma once

#include <memory>
#include <vector>

#include "engine/bench/report_table.h"
#include "engine/bench/timing.h"

namespace moltact::bench {

struct ColdCacheTimes {
  const Method* method = nullptr;
  Statistics sleeping_ns;  ///< one tick a millisecond
  Statistics thrashed_ns;  ///< each tick after kThrashed_bytes have been read and written
  double touching = 0;     ///< fraction of these ticks in contact (0 to 1)
};

struct ColdCachePlan {
  std::size_t sleeping_ticks = 1000, thrashed_ticks = 200;  ///< of each method
};

inline constexpr std::size_t kThrashed_bytes = std::size_t(64) << 20;

/// The strokes must have as many counted ticks as the plan asks for, over all.
std::vector<ColdCacheTimes> timeColdCache(std::span<const Method* const> methods,
                                          const std::shared_ptr<const SphereGrid>& scene, double probe_A,
                                          const std::vector<Stroke>& strokes, const ColdCachePlan& plan,
                                          const Progress& progress);

/// `hot`: the same methods' times in a row, for the mean beside.
ReportTable coldCacheTable(const std::vector<ColdCacheTimes>& cool, const std::vector<TickTimes>& hot,
                           std::size_t spheres);

}  // namespace moltact::bench
