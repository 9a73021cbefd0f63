// The haptic thread: reads the device, steps the tracker, writes the force, 1000 times a second, at real-time priority
// where the system allows it. Everything crosses to and from it whole and without locks.
// All public functions are for the owning thread (the window's), none blocks but the destructor.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <thread>

#include "engine/device/device.h"
#include "engine/platform/realtime.h"
#include "engine/core/sample_ring.h"
#include "engine/servo/servo_step.h"
#include "engine/core/triple_buffer.h"

namespace moltact {

class ServoThread {
 public:
  /// Starts the loop at once. `device` must outlive the thread.
  explicit ServoThread(Device& device);
  /// Gives zero force, ends the loop and waits for it (at most about a tick).
  ~ServoThread();
  ServoThread(const ServoThread&) = delete;
  ServoThread& operator=(const ServoThread&) = delete;

  void setSettings(const ServoSettings& settings) noexcept { settings_.write(settings); }

  /// Hands over the tracker of a scene (null: none), whose number comes back in every sample that this tracker makes.
  /// Settings set before are in force when it is first stepped. The old one comes back and is destroyed here, never on the
  /// loop.
  void setTracker(std::unique_ptr<Tracker> tracker, std::uint32_t scene = 0);

  /// The newest tick.
  const ServoSample& latest() noexcept { return latest_.read(); }

  /// Calls take(sample) for every tick since the last call, oldest first (the last 4 s at most). Call it each frame:
  /// it also destroys trackers that the loop has given back.
  template <class Take>
  void drain(Take&& take) {
    collect();
    ServoSample sample;
    while (samples_.pop(sample)) take(sample);
  }

  /// Whether the loop runs at real-time priority, and if not, why; set soon after the start.
  RealtimeStatus realtime() const noexcept { return realtime_.load(std::memory_order_acquire); }

  /// Ticks that were left out because the loop fell more than kCatchUp_ticks behind.
  std::uint64_t missedTicks() const noexcept { return missed_.load(std::memory_order_relaxed); }

 private:
  static constexpr int kCatchUp_ticks = 5;
  void run() noexcept;
  void collect();

  Device& device_;
  TripleBuffer<ServoSettings> settings_;
  TripleBuffer<ServoSample> latest_;
  SampleRing<ServoSample, 4096> samples_;
  // A tracker on its way, with its scene's number; no tracker in it: none is wanted.
  struct Handed {
    std::unique_ptr<Tracker> tracker;
    std::uint32_t scene = 0;
  };
  std::atomic<Handed*> arriving_{nullptr};    // the next
  std::atomic<Handed*> leaving_{nullptr};     // one that the loop has put down
  Handed* current_ = nullptr;                 // the loop's
  std::atomic<RealtimeStatus> realtime_{RealtimeStatus::Starting};
  std::atomic<std::uint64_t> missed_{0};
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

}  // namespace moltact
