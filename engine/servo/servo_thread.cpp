#include "engine/servo/servo_thread.h"

namespace moltact {
namespace {

// Stands in the mailbox for "take the tracker away": a null there means that nothing has come.
class NoTracker final : public Tracker {
 public:
  Contact step(PointA hip) noexcept override { return {.scp = hip}; }
  void reset() noexcept override {}
  void setProbe(double) noexcept override {}
  double probe_A() const noexcept override { return 0.0; }
  Footprint footprint() const noexcept override { return {}; }
};

}  // namespace

ServoThread::ServoThread(Device& device) : device_(device), none_owner_(std::make_unique<NoTracker>()) {
  none_ = none_owner_.get();
  thread_ = std::thread([this] { run(); });
}

ServoThread::~ServoThread() {
  stop_.store(true, std::memory_order_release);
  thread_.join();
  collect();
  if (Tracker* waiting = arriving_.exchange(nullptr); waiting != none_) delete waiting;
  delete current_;
}

void ServoThread::setTracker(std::unique_ptr<Tracker> tracker) {
  collect();
  Tracker* next = tracker ? tracker.release() : none_;
  Tracker* overtaken = arriving_.exchange(next, std::memory_order_acq_rel);
  if (overtaken != none_) delete overtaken;
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
      Tracker* next = arriving_.exchange(nullptr, std::memory_order_acq_rel);
      if (current_) leaving_.store(current_, std::memory_order_release);
      current_ = next == none_ ? nullptr : next;
    }

    const DevicePose pose = device_.read(kTick_s);
    ServoSample sample = step.tick(settings_.read(), current_, pose);
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
