// The system's calls behind force_inhibit.cpp. All but catchEndings() may be called in a signal handler.
#pragma once

#include <cstdint>

namespace moltact::platform {

/// Sleeps.
void rest_ns(std::int64_t time) noexcept;
/// Of a clock that never goes back.
std::int64_t now_ns() noexcept;

/// From the first call on, whatever ends the process calls endForce(), and what stops it does the acts (doLastActs).
void catchEndings() noexcept;

/// Does every armed act, until each is done or kPatience_ms are over. Defined in force_inhibit.cpp.
void doLastActs() noexcept;

}  // namespace moltact::platform
