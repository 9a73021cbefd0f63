#include "engine/device/omni/omni_guard.h"

#include <chrono>

#include "engine/platform/force_inhibit.h"
#include "engine/platform/realtime.h"

namespace moltact {
namespace {

constexpr auto kLook = std::chrono::milliseconds(4);
constexpr std::int64_t kMs_ns = 1'000'000;

}  // namespace

void OmniGuard::start() {
  stop();
  last_ns_.store(monotonic_ns());
  cut_.store(false);
  ends_.store(false);
  thread_ = std::thread([this] { run(); });
}

void OmniGuard::stop() {
  ends_.store(true);
  if (thread_.joinable()) thread_.join();
}

void OmniGuard::frame() noexcept {
  last_ns_.store(monotonic_ns(), std::memory_order_relaxed);
  frames_.fetch_add(1, std::memory_order_release);
}

void OmniGuard::run() noexcept {
  while (!ends_.load()) {
    std::this_thread::sleep_for(kLook);
    look();
  }
}

void OmniGuard::look() noexcept {
  const std::uint32_t frames = frames_.load(std::memory_order_acquire);
  const std::int64_t silent_ns = monotonic_ns() - last_ns_.load(std::memory_order_relaxed);
  const bool stalled = silent_ns > kMs_ns * (forceInhibited() ? kStalledInhibited_ms : kStalled_ms);
  if (!cut_.load() && stalled) {
    hd::switchForce(hd_, false);
    frames_at_cut_ = frames;
    cut_.store(true, std::memory_order_release);
  } else if (cut_.load() && !stalled && frames - frames_at_cut_ >= 2) {
    // Two frames have known that it is off, and have written no force.
    hd::switchForce(hd_, true);
    cut_.store(false, std::memory_order_release);
  }
}

}  // namespace moltact
