// The noise floor of comparisons with exact: exact with a slightly smaller probe, a difference that no finger can feel.
// Differences below this floor cannot be resolved. Units: angstrom.
#pragma once

#include <span>

#include "engine/haptics/methods.h"

namespace moltact::bench {

/// exact with a probe 0.001 A and 0.02 A smaller, as methods named "exact-0.001" and "exact-0.02".
std::span<const Method> noiseFloor();

}  // namespace moltact::bench
