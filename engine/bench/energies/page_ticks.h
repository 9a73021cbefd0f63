// The time of a tick in the browser edition's compilation, measured under Node.js by moltact_energy_ticks
// (tests/hip_path) and shown in the chart of energies. The program that measures writes one line for each method.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/bench/energies/energy_trade_off.h"

namespace moltact::bench {

/// The methods that are timed in a page: the program's own sum and the two grids of the usual spacing.
std::vector<EnergyMethod> pageEnergyMethods();

/// "body,method,mean_us,p999_us" and a line for each measured point. Microseconds.
std::string pageTickLines(const std::vector<EnergyTradeOff>& points);

/// Sets `page_mean_us` and `page_p999_us` of the points that these lines name. A Problem, with the line's number, for a
/// line of another form, a time that is not positive, or a body or method that the chart lacks. Lines of points that
/// were not measured here have no effect.
std::optional<Problem> addPageTicks(const std::string& lines, std::vector<EnergyTradeOff>& points);

}  // namespace moltact::bench
