// Counts involuntary context switches. Not for the haptic thread (a system call).
#pragma once

#include <cstdint>

namespace moltact {

/// Number of involuntary context switches of this thread since its start.
std::uint64_t preemptionsOfThisThread();

}  // namespace moltact
