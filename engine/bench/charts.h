// The two charts of the bench as SVG: speed against accuracy, and memory and ready time against the number of
// atoms.
#pragma once

#include <string>
#include <vector>

#include "engine/bench/tables.h"
#include "engine/bench/trade_off.h"

namespace moltact::bench {

/// Time a tick against the SCP's error and against the force's; the front of best trade-offs as a dashed
/// line.
std::string tradeOffChart(const std::vector<TradeOff>& points, std::size_t spheres);

/// Memory and ready time against the number of atoms, a line a method, with atoms modelled of loaded at
/// exact's points.
std::string sizeChart(const std::vector<SceneTimes>& times);

}  // namespace moltact::bench
