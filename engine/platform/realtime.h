// The haptic thread's interface to the operating system: its clock, its sleep and its priority.
#pragma once

#include <cstdint>

namespace moltact {

enum class RealtimeStatus : std::uint8_t {
  Starting,
  Realtime,  ///< first-in-first-out scheduling: the window cannot delay the loop
  Ordinary,  ///< the system did not allow it; ticks may come late while the window is busy
};

/// Asks for real-time scheduling and locked memory for the calling thread; returns what was granted.
RealtimeStatus becomeRealtime() noexcept;

/// Monotonic time (unit: nanosecond).
std::int64_t monotonic_ns() noexcept;

/// Sleeps until monotonic_ns() reaches `due_ns`; returns at once when that is past.
void sleepUntil(std::int64_t due_ns) noexcept;

}  // namespace moltact
