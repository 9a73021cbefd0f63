// Counts how often the operating system has taken the processor away. Not for the haptic thread (a call of the system).
#pragma once

#include <cstdint>

namespace moltact {

/// Times that this thread has been taken off its processor against its will since it began.
std::uint64_t preemptionsOfThisThread();

}  // namespace moltact
