// The haptic thread's interface to the operating system: clock, sleep and priority.
#pragma once

#include <cstdint>

namespace moltact {

enum class RealtimeStatus : std::uint8_t {
  Starting,
  Realtime,  ///< first-in-first-out scheduling: the window cannot delay the loop
  Ordinary,  ///< refused by the system; ticks may be late while the window is busy
};

/// Requests real-time scheduling and locked memory for the calling thread; returns what the system granted.
RealtimeStatus becomeRealtime() noexcept;

/// Monotonic time (unit: nanosecond).
std::int64_t monotonic_ns() noexcept;

/// Sleeps until monotonic_ns() reaches `due_ns`; returns immediately if that time is past.
void sleepUntil(std::int64_t due_ns) noexcept;

}  // namespace moltact
