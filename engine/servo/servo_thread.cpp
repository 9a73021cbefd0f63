#include "engine/servo/servo_thread.h"

#include <utility>

namespace moltact {

ServoThread::ServoThread(Device& device) : device_(device), thread_([this] { run(); }) {}

ServoThread::~ServoThread() {
  stop_.store(true, std::memory_order_release);
  thread_.join();
  collect();
  delete arriving_.exchange(nullptr);
  delete current_;
}

void ServoThread::setTracker(std::unique_ptr<Tracker> tracker, std::uint32_t scene) {
  collect();
  auto next = std::make_unique<Handed>(std::move(tracker), scene);
  delete arriving_.exchange(next.release(), std::memory_order_acq_rel);
}

void ServoThread::collect() { delete leaving_.exchange(nullptr, std::memory_order_acq_rel); }

void ServoThread::run() noexcept {
  realtime_.store(becomeRealtime(), std::memory_order_release);
  constexpr std::int64_t period_ns = 1'000'000;
  ServoStep step;
  std::int64_t due_ns = monotonic_ns() + period_ns;
  while (!stop_.load(std::memory_order_acquire)) {
    sleepUntil(due_ns);
    const std::int64_t began_ns = monotonic_ns();

    // A new tracker is taken only when the place for the old one is free, so that nothing is ever destroyed here.
    if (arriving_.load(std::memory_order_acquire) && !leaving_.load(std::memory_order_acquire)) {
      Handed* next = arriving_.exchange(nullptr, std::memory_order_acq_rel);
      if (current_) leaving_.store(current_, std::memory_order_release);
      current_ = next;
    }

    const DevicePose pose = device_.read(kTick_s);
    ServoSample sample = step.tick(settings_.read(), current_ ? current_->tracker.get() : nullptr, pose);
    sample.scene = current_ ? current_->scene : 0;
    device_.write(sample.force);
    sample.work_us = float(monotonic_ns() - began_ns) * 1e-3f;
    sample.late_us = float(began_ns - due_ns) * 1e-3f;
    latest_.write(sample);
    samples_.push(sample);

    // A few missed ticks are caught up one after the other; after a long stall the loop begins anew from now.
    due_ns += period_ns;
    if (const std::int64_t behind = (began_ns - due_ns) / period_ns; behind > kCatchUp_ticks) {
      missed_.fetch_add(std::uint64_t(behind), std::memory_order_relaxed);
      due_ns += behind * period_ns;
    }
  }
  device_.write(ForceN{});
}

}  // namespace moltact
