#include "engine/device/omni/omni_guard.h"

#include <chrono>

#include "engine/platform/force_inhibit.h"

namespace moltact {
namespace {

constexpr auto kLook = std::chrono::milliseconds(4);
constexpr std::int64_t kMs_ns = 1'000'000;

}  // namespace

void OmniGuard::start() {
  stop();
  last_ns_.store(now_ns_());
  clean_frames_.store(0);  // the output stays off until two frames without force have been written
  ends_.store(false);
  thread_ = std::thread([this] { run(); });
}

void OmniGuard::stop() {
  ends_.store(true);
  if (thread_.joinable()) thread_.join();
}

void OmniGuard::frame() noexcept { last_ns_.store(now_ns_(), std::memory_order_release); }

void OmniGuard::switchOff() noexcept {
  failures_.fetch_add(1);
  cut_.store(true, std::memory_order_release);
  clean_frames_.store(0);
  hd::switchForce(hd_, false);
}

void OmniGuard::run() noexcept {
  while (!ends_.load()) {
    std::this_thread::sleep_for(kLook);
    look();
  }
}

void OmniGuard::look() noexcept {
  const std::uint32_t failures = failures_.load();
  // In this order: if this thread is preempted in between, it sees a newer frame, not an older one.
  const std::int64_t now_ns = now_ns_(), silent_ns = now_ns - last_ns_.load(std::memory_order_acquire);
  const bool stalled = silent_ns > kMs_ns * (forceInhibited() ? kStalledInhibited_ms : kStalled_ms);
  if (!cut_.load() && stalled) {
    hd::switchForce(hd_, false);
    cut_.store(true, std::memory_order_release);
    clean_frames_.store(0);
  } else if (cut_.load() && !stalled && clean_frames_.load(std::memory_order_acquire) >= 2) {
    // At least one complete frame began after the output was switched off; it wrote no force, and the driver accepted
    // it.
    hd::switchForce(hd_, true);
    cut_.store(false, std::memory_order_release);
    // A frame that failed meanwhile switched the output off before this thread switched it on.
    if (failures_.load() != failures) {
      cut_.store(true, std::memory_order_release);
      hd::switchForce(hd_, false);
    }
  }
}

}  // namespace moltact
