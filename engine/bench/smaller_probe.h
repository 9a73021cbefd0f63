// The noise floor of comparisons with exact: the method `exact` with a slightly smaller probe. The difference is
// assumed to be below perception (touch_thresholds.h).
// Differences below this floor cannot be resolved. Units: angstrom.
#pragma once

#include <span>

#include "engine/haptics/methods.h"

namespace moltact::bench {

/// The method `exact` with a probe 0.001 A and 0.02 A smaller, as methods named "exact-0.001" and "exact-0.02".
std::span<const Method> noiseFloor();

}  // namespace moltact::bench
