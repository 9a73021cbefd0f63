// The resolution of a clock, estimated from its readings. Many clocks count in coarse steps but report nanoseconds:
// differences of readings are then multiples of the step, rounded to whole nanoseconds. Not for the haptic thread.
// Unit: nanosecond.
#pragma once

#include <vector>

namespace moltact::bench {

/// The largest step of which all differences are multiples within rounding to whole nanoseconds; 1 if there is none.
double stepOf(const std::vector<double>& differences_ns);

/// The resolution of the clock that times the ticks, measured now. Blocks for some milliseconds.
double clockStep_ns();

}  // namespace moltact::bench
