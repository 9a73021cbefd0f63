// The two charts of the bench as SVG: speed against accuracy, and memory and ready time against the number of atoms.
#pragma once

#include <string>
#include <vector>

#include "engine/bench/tables.h"
#include "engine/bench/trade_off.h"

namespace moltact::bench {

/// Time a tick against the error of the SCP and of the force; the front of best trade-offs is a dashed line.
std::string tradeOffChart(const std::vector<TradeOff>& points, std::size_t spheres);

/// Memory and ready time against the number of atoms, one line for each method; exact's points are labelled with the
/// atoms modelled out of those loaded.
std::string sizeChart(const std::vector<SceneTimes>& times);

}  // namespace moltact::bench
