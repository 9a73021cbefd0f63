// System calls for force_inhibit.cpp. All except catchEndings() may be called in a signal handler.
#pragma once

#include <cstdint>

namespace moltact::platform {

/// Sleeps for `time` nanoseconds.
void rest_ns(std::int64_t time) noexcept;
/// Monotonic time.
std::int64_t now_ns() noexcept;

/// Installs the handlers: the end of the process then calls endForce(), and a stop signal calls doLastActs().
void catchEndings() noexcept;

/// Performs every armed act until each is done or kPatience_ms have passed. Defined in force_inhibit.cpp.
void doLastActs() noexcept;

}  // namespace moltact::platform
