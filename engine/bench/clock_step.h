// The resolution of a clock, from its readings. Many clocks count in coarser steps of their own and report nanoseconds:
// their readings differ by whole numbers of nanoseconds that are, but for rounding, multiples of that coarser step. Not
// for the haptic thread. Unit: nanosecond.
#pragma once

#include <vector>

namespace moltact::bench {

/// The largest step of which all differences are multiples, but for their rounding to whole nanoseconds; 1 where there
/// is no larger one.
double stepOf(const std::vector<double>& differences_ns);

/// The resolution of the clock that times the ticks, measured now (takes some milliseconds).
double clockStep_ns();

}  // namespace moltact::bench
