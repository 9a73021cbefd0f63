// Tick times with cold caches, as in real use. Measures ticks in contact at 1 kHz with sleep between, as on the haptic
// thread, and ticks after other work has filled the caches. Single ticks are timed; the methods alternate. Runs on the
// calling thread. Units: nanosecond.
#pragma once

#include <memory>
#include <vector>

#include "engine/bench/report_table.h"
#include "engine/bench/timing.h"

namespace moltact::bench {

struct ColdCacheTimes {
  const Method* method = nullptr;
  Statistics sleeping_ns;  ///< one tick per millisecond
  Statistics thrashed_ns;  ///< each tick after reading and writing kThrashed_bytes
  double touching = 0;     ///< fraction of these ticks in contact (0 to 1)
};

struct ColdCachePlan {
  std::size_t sleeping_ticks = 1000, thrashed_ticks = 200;  ///< per method
};

inline constexpr std::size_t kThrashed_bytes = std::size_t(64) << 20;

/// The strokes together must contain at least as many counted ticks as the plan requires.
std::vector<ColdCacheTimes> timeColdCache(std::span<const Method* const> methods,
                                          const std::shared_ptr<const SphereGrid>& scene, double probe_A,
                                          const std::vector<Stroke>& strokes, const ColdCachePlan& plan,
                                          const Progress& progress);

/// `hot`: times of consecutive ticks of the same methods, for comparison of the means.
ReportTable coldCacheTable(const std::vector<ColdCacheTimes>& cool, const std::vector<TickTimes>& hot,
                           std::size_t spheres);

}  // namespace moltact::bench
