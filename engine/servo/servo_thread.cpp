#include "engine/servo/servo_thread.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "engine/platform/force_hold.h"

namespace moltact {

ServoThread::ServoThread(Device& fallback) : fallback_(fallback) { start(); }

ServoThread::~ServoThread() {
  finish();
  collect();
  delete arriving_.exchange(nullptr);
  delete current_;
}

void ServoThread::start() {
  // The old step's count goes on, so that samples are numbered without a gap.
  if (!step_) step_.emplace(fallback_.info());
  switch_.emplace(fallback_, chosen_.get());
  time_ = {};
  const std::int64_t begun_ns = last_ns_ = monotonic_ns();
  device_tick_ns_.store(0, std::memory_order_relaxed);
  stop_.store(false, std::memory_order_release);
  // From here on the device's clock may already tick, and last_ns_ is its own.
  if (chosen_ && chosen_->startClock(*this)) device_tick_ns_.store(begun_ns, std::memory_order_release);
  thread_ = std::thread([this] { run(); });
}

void ServoThread::endForce() {
  for_good_ = true;
  release();
}

void ServoThread::release() {
  released_.store(true, std::memory_order_release);
  const std::int64_t until_ns = monotonic_ns() + kRelease_ms * std::int64_t{1'000'000};
  // One tick more than the one that gave none: it may have begun before.
  for (int none = 0; chosen_ && none < 2 && monotonic_ns() < until_ns;
       none = gives_.load(std::memory_order_acquire) ? 0 : none + 1)
    std::this_thread::sleep_for(std::chrono::nanoseconds(kPeriod_ns));
}

void ServoThread::finish() {
  release();
  stop_.store(true, std::memory_order_release);
  thread_.join();
  if (chosen_) {
    chosen_->stopClock();
    chosen_->stop();
  }
  fallback_.write(ForceN{});
  released_.store(for_good_, std::memory_order_release);
}

void ServoThread::setDevice(std::unique_ptr<Device> device) {
  finish();
  switch_.reset();
  chosen_ = std::move(device);
  start();
}

void ServoThread::record(bool on) {
  finish();
  if (on) recording_ = std::make_unique<Recording>();
  records_.store(on, std::memory_order_release);
  start();
}

void ServoThread::setTracker(std::unique_ptr<Tracker> tracker, std::uint32_t scene) {
  collect();
  auto next = std::unique_ptr<Handed>(new Handed{
      std::move(tracker), scene});  // not made by make_unique, which clang before 16 cannot do with an aggregate
  delete arriving_.exchange(next.release(), std::memory_order_acq_rel);
}

void ServoThread::collect() { delete leaving_.exchange(nullptr, std::memory_order_acq_rel); }

void ServoThread::run() noexcept {
  realtime_.store(becomeRealtime(), std::memory_order_release);
  std::int64_t due_ns = monotonic_ns() + kPeriod_ns;
  while (!stop_.load(std::memory_order_acquire)) {
    sleepUntil(due_ns);
    const std::int64_t began_ns = monotonic_ns();
    // While the device's own clock ticks this one only watches; when that stops, this one takes over.
    if (began_ns - device_tick_ns_.load(std::memory_order_acquire) > kOwnClock_ns) tickOnce(due_ns);

    // A few missed ticks are caught up one after the other; after a long stall the loop begins anew from now.
    due_ns += kPeriod_ns;
    if (const std::int64_t behind = (began_ns - due_ns) / kPeriod_ns; behind > kCatchUp_ticks) {
      missed_.fetch_add(std::uint64_t(behind), std::memory_order_relaxed);
      due_ns += behind * kPeriod_ns;
    }
  }
}

void ServoThread::tickOfDevice() noexcept {
  device_tick_ns_.store(monotonic_ns(), std::memory_order_release);
  if (!stop_.load(std::memory_order_acquire)) tickOnce(std::nullopt);
}

// The newest settings; without force where their owner stands still or lets it go, or the process ends.
ServoSettings ServoThread::watchedSettings(double dt_s) noexcept {
  ServoSettings settings = settings_.read();
  const std::uint32_t heartbeat = heartbeat_.load(std::memory_order_relaxed);
  silent_s_ = heartbeat != last_heartbeat_ ? 0.0 : silent_s_ + std::max(0.0, dt_s);
  last_heartbeat_ = heartbeat;
  if (expects_.load(std::memory_order_relaxed) && silent_s_ > kWatchdog_s) settings.force_on = false;
  if (released_.load(std::memory_order_acquire)) settings.force_on = false;
  if (forceHeld()) settings.panic = true;
  return settings;
}

void ServoThread::tickOnce(std::optional<std::int64_t> due_ns) noexcept {
  // Both clocks at once, which happens for a tick when one takes over from the other: the first one ticks.
  if (ticking_.test_and_set(std::memory_order_acquire)) return;
  const std::int64_t began_ns = monotonic_ns();

  // A new tracker is taken only when the place for the old one is free, so that nothing is ever destroyed here.
  if (arriving_.load(std::memory_order_acquire) && !leaving_.load(std::memory_order_acquire)) {
    Handed* next = arriving_.exchange(nullptr, std::memory_order_acq_rel);
    if (current_) leaving_.store(current_, std::memory_order_release);
    current_ = next;
    if (recording_) recording_->begun = true;
  }

  const std::int64_t late_ns = began_ns - due_ns.value_or(std::min(began_ns, last_ns_ + kPeriod_ns));
  time_.dt_s = double(began_ns - last_ns_) * 1e-9;
  last_ns_ = began_ns;
  const bool records = records_.load(std::memory_order_acquire) && recording_->begun;
  if (records && !recording_->started) {
    step_->forgetTracker();
    recording_->start = *step_;
    recording_->started = true;
  }
  const ServoSettings settings = watchedSettings(time_.dt_s);
  const DevicePose pose = switch_->read(kTick_s, *step_);
  ServoSample sample = step_->tick(settings, current_ ? current_->tracker.get() : nullptr, pose, time_);
  const TickTime time_was = time_;
  sample.scene = current_ ? current_->scene : 0;
  switch_->write(sample.force, sample.limits.has(Limit::Panic));
  fallen_back_.store(switch_->fallenBack(), std::memory_order_relaxed);
  gives_.store(!switch_->fallenBack() && sample.force.N != Vec3(0.0), std::memory_order_release);
  const std::int64_t work_ns = monotonic_ns() - began_ns;
  time_.delay_s = double(work_ns) * 1e-9;
  sample.work_us = float(work_ns) * 1e-3f;
  sample.late_us = float(late_ns) * 1e-3f;
  latest_.write(sample);
  samples_.push(sample);
  if (records)
    recording_->ring.push({settings, pose, time_was, switch_->info(), switch_->other(), sample.force,
                           switch_->fallenBack(), sample.contact.touching(), sample.limits});
  ticking_.clear(std::memory_order_release);
}

}  // namespace moltact
