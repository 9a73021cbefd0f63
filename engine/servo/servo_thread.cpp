#include "engine/servo/servo_thread.h"

#include <utility>

namespace moltact {

ServoThread::ServoThread(Device& fallback, const LoopClock& clock) : clock_(clock), loop_(fallback) { start(); }

ServoThread::~ServoThread() { finish(); }

void ServoThread::start() {
  const std::int64_t begun_ns = clock_.now_ns();
  loop_.begin(begun_ns);
  device_tick_ns_.store(0, std::memory_order_relaxed);
  stop_.store(false, std::memory_order_release);
  // From here on the device's clock may tick.
  if (loop_.device() && loop_.device()->startClock(*this)) device_tick_ns_.store(begun_ns, std::memory_order_release);
  thread_ = std::thread([this] { run(); });
}

void ServoThread::endForce() {
  loop_.endForce();
  release();
}

void ServoThread::release() {
  loop_.release([this] { clock_.sleepUntil(clock_.now_ns() + ServoLoop::kPeriod_ns); });
}

void ServoThread::finish() {
  release();
  stop_.store(true, std::memory_order_release);
  thread_.join();
  if (loop_.device()) loop_.device()->stopClock();
  loop_.end();
}

void ServoThread::setDevice(std::unique_ptr<Device> device) {
  finish();
  loop_.setDevice(std::move(device));
  start();
}

void ServoThread::record(bool on) {
  finish();
  loop_.record(on);
  start();
}

void ServoThread::run() noexcept {
  realtime_.store(becomeRealtime(), std::memory_order_release);
  std::int64_t due_ns = clock_.now_ns() + ServoLoop::kPeriod_ns;
  while (!stop_.load(std::memory_order_acquire)) {
    clock_.sleepUntil(due_ns);
    const std::int64_t began_ns = clock_.now_ns();
    // While the device's own clock ticks, this thread only watches; when it stops, this thread takes over.
    if (began_ns - device_tick_ns_.load(std::memory_order_acquire) > kOwnClock_ns)
      loop_.tick(began_ns, due_ns, clock_.now_ns);

    // A few missed ticks are caught up in sequence; after a long stall the loop restarts from the present time.
    due_ns += ServoLoop::kPeriod_ns;
    if (const std::int64_t behind = (began_ns - due_ns) / ServoLoop::kPeriod_ns; behind > kCatchUp_ticks) {
      missed_.fetch_add(std::uint64_t(behind), std::memory_order_relaxed);
      due_ns += behind * ServoLoop::kPeriod_ns;
    }
  }
}

void ServoThread::onDeviceTick() noexcept {
  const std::int64_t now_ns = clock_.now_ns();
  device_tick_ns_.store(now_ns, std::memory_order_release);
  if (!stop_.load(std::memory_order_acquire)) loop_.tick(now_ns, std::nullopt, clock_.now_ns);
}

}  // namespace moltact
