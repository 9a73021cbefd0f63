// The noise floor of every comparison with exact: exact itself with a probe that is smaller by so little that no finger
// feels it. A difference between this and exact cannot be resolved any finer. Units: angstrom.
#pragma once

#include <span>

#include "engine/haptics/methods.h"

namespace moltact::bench {

/// exact with a probe 0.001 A and 0.02 A smaller, as methods of the names "exact-0.001" and "exact-0.02".
std::span<const Method> noiseFloor();

}  // namespace moltact::bench
