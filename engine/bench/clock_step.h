// The step of a clock from its readings. Many clocks count in steps of their own and tell nanoseconds: their readings
// differ by any whole number of nanoseconds, but lie on a comb of coarser teeth. Not for the haptic thread. Unit:
// nanosecond.
#pragma once

#include <vector>

namespace moltact::bench {

/// The widest step of which all differences are multiples but for their rounding to whole nanoseconds; 1 where there is
/// none wider.
double stepOf(const std::vector<double>& differences_ns);

/// The same of the clock that ticks are timed by, measured now (takes some milliseconds).
double clockStep_ns();

}  // namespace moltact::bench
