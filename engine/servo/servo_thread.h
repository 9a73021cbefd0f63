// The haptic thread: runs a servo loop (servo_loop.h) at 1000 ticks a second, or by the device's own clock if it has
// one. It has real-time priority if the system allows it. All public functions are for the owning thread (the
// window's). Only the destructor, setDevice(), record() and endForce() block.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <thread>

#include "engine/platform/realtime.h"
#include "engine/servo/servo_loop.h"

namespace moltact {

/// The thread's clock: the wall clock, or that of a test.
struct LoopClock {
  std::int64_t (*now_ns)() = &monotonic_ns;
  void (*sleepUntil)(std::int64_t) = &moltact::sleepUntil;
};

class ServoThread final : private ClockListener {
 public:
  /// Starts the loop immediately. `fallback` is read while no other device is chosen or the chosen one is disconnected;
  /// it must outlive the thread.
  explicit ServoThread(Device& fallback, const LoopClock& clock = {});
  /// Ramps the force down along the slew limit, ends the loop and waits for it (at most about ServoLoop::kRelease_ms).
  ~ServoThread();
  ServoThread(const ServoThread&) = delete;
  ServoThread& operator=(const ServoThread&) = delete;

  /// The loop, for all data exchange with the ticks.
  ServoLoop& loop() noexcept { return loop_; }
  const ServoLoop& loop() const noexcept { return loop_; }

  /// Sets the device to use; null: the fallback. The old device's force is ramped down along the slew limit. The loop
  /// then pauses for some ticks without force, and the old device is closed on this thread.
  void setDevice(std::unique_ptr<Device> device);
  /// Records every tick with all its inputs, starting with the tick that receives the next interaction, until called
  /// with false. The force is ramped down meanwhile, as in setDevice().
  void record(bool on);

  /// Ramps the force down along the slew limit and gives none afterwards. Returns when there is none, after at most
  /// ServoLoop::kRelease_ms. Call it first when the program ends.
  void endForce();

  /// The scheduling of the loop; set soon after the start.
  RealtimeStatus realtime() const noexcept { return realtime_.load(std::memory_order_acquire); }

  /// Number of ticks skipped because the loop was more than kCatchUp_ticks late.
  std::uint64_t missedTicks() const noexcept { return missed_.load(std::memory_order_relaxed); }

 private:
  static constexpr int kCatchUp_ticks = 5;
  // A device's own clock is used while it ticks at least this often.
  static constexpr std::int64_t kOwnClock_ns = 10'000'000;
  void start();
  void release();
  void finish();
  void run() noexcept;
  void onDeviceTick() noexcept override;

  LoopClock clock_;
  ServoLoop loop_;
  std::atomic<RealtimeStatus> realtime_{RealtimeStatus::Starting};
  std::atomic<std::uint64_t> missed_{0};
  std::atomic<bool> stop_{false};
  std::atomic<std::int64_t> device_tick_ns_{0};
  std::thread thread_;
};

}  // namespace moltact
