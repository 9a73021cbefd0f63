// Speed against accuracy: time per tick and errors of SCP and force for each method, and the Pareto front.
#pragma once

#include <vector>

#include "engine/bench/accuracy.h"
#include "engine/bench/report_table.h"
#include "engine/bench/timing.h"

namespace moltact::bench {

struct TradeOff {
  const Method* method = nullptr;
  double tick_ns = 0;  ///< mean in contact
  Accuracy accuracy;   ///< against exact; exact's own against the oracle
  MemoryUsage memory_usage;
  bool best_scp = false, best_direction = false;  ///< on the Pareto front
};

struct TradeOffOptions {
  std::vector<const Method*> methods;
  std::size_t spheres = 13'751;
  double probe_A = kWaterProbe_A;
  StrokePlan plan;
  double budget_s = 0.5;
  std::uint64_t seed = 1;
};

std::vector<TradeOff> measureTradeOffs(const TradeOffOptions& options, const Progress& progress);

ReportTable tradeOffTable(const std::vector<TradeOff>& points, const TradeOffOptions& options);

}  // namespace moltact::bench
