#include <emscripten.h>

#include "engine/platform/realtime.h"

namespace moltact {

RealtimeStatus becomeRealtime() noexcept { return RealtimeStatus::Ordinary; }

std::int64_t monotonic_ns() noexcept { return std::int64_t(emscripten_get_now() * 1e6); }

// A page must not block; its ticks follow the frames' clock and never call this.
void sleepUntil(std::int64_t) noexcept {}

}  // namespace moltact
