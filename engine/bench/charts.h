// The two charts of the bench as SVG: speed against accuracy, and memory and ready time against the number of atoms.
#pragma once

#include <string>
#include <vector>

#include "engine/bench/tables.h"
#include "engine/bench/trade_off.h"

namespace moltact::bench {

/// Time per tick against the errors of SCP and force; the Pareto front is a dashed line.
std::string tradeOffChart(const std::vector<TradeOff>& points, std::size_t spheres);

/// Memory and ready time against the number of atoms, one line per method. Points of exact are labelled with the
/// numbers of modelled and loaded atoms.
std::string sizeChart(const std::vector<SceneTimes>& times);

}  // namespace moltact::bench
