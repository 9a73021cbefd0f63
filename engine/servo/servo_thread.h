// The haptic thread: ticks a servo loop (servo_loop.h) 1000 times a second, at real-time priority where the system
// allows it, or by a device's own clock where the device brings one. All public functions are for the owning thread
// (the window's); none blocks except the destructor, setDevice(), record() and endForce().
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <thread>

#include "engine/platform/realtime.h"
#include "engine/servo/servo_loop.h"

namespace moltact {

/// The thread's clock: the wall clock, or a test's.
struct LoopClock {
  std::int64_t (*now_ns)() = &monotonic_ns;
  void (*sleepUntil)(std::int64_t) = &moltact::sleepUntil;
};

class ServoThread final : private ClockListener {
 public:
  /// Starts the loop at once. `fallback` is read while no other device is chosen or the chosen one is gone; it must
  /// outlive the thread.
  explicit ServoThread(Device& fallback, const LoopClock& clock = {});
  /// Ramps the force down along the slew, ends the loop and waits for it (some ticks, at most about
  /// ServoLoop::kRelease_ms).
  ~ServoThread();
  ServoThread(const ServoThread&) = delete;
  ServoThread& operator=(const ServoThread&) = delete;

  /// The loop, for everything that crosses to and from the ticks.
  ServoLoop& loop() noexcept { return loop_; }
  const ServoLoop& loop() const noexcept { return loop_; }

  /// Sets the device to be used from now on; null: the fallback. The old device's force is ramped down along the slew.
  /// Then the loop pauses for some ticks, without force, and the old device is closed here.
  void setDevice(std::unique_ptr<Device> device);
  /// Records every tick with all its inputs, from the tick in which the next interaction is handed over, until false.
  /// The force is ramped down meanwhile, as for another device.
  void record(bool on);

  /// Ramps the force down along the slew and gives none from then on. Returns when there is none, after
  /// ServoLoop::kRelease_ms at the latest. For the program's end, before anything else is done there.
  void endForce();

  /// Whether the loop runs at real-time priority, and if not, why; set soon after the start.
  RealtimeStatus realtime() const noexcept { return realtime_.load(std::memory_order_acquire); }

  /// Ticks that were skipped because the loop fell more than kCatchUp_ticks behind.
  std::uint64_t missedTicks() const noexcept { return missed_.load(std::memory_order_relaxed); }

 private:
  static constexpr int kCatchUp_ticks = 5;
  // A device's own clock is used as long as it ticks at least this often.
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
