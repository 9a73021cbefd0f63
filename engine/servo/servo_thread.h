// The haptic thread: reads the device, steps the tracker, writes the force, 1000 times a second, at real-time priority
// where the system allows it; by a device's own clock where it brings one. Everything crosses to and from it whole and
// without locks. All public functions are for the owning thread (the window's), none blocks but the destructor.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <thread>

#include "engine/core/sample_ring.h"
#include "engine/core/triple_buffer.h"
#include "engine/device/device.h"
#include "engine/platform/realtime.h"
#include "engine/servo/device_switch.h"
#include "engine/servo/servo_recording.h"
#include "engine/servo/servo_step.h"

namespace moltact {

class ServoThread final : private TickTarget {
 public:
  /// Starts the loop at once. `fallback` is read while no other device is chosen or the chosen one is gone; it must
  /// outlive the thread.
  explicit ServoThread(Device& fallback);
  /// Lets the force go along the slew, ends the loop and waits for it (some ticks, at most about kRelease_ms).
  ~ServoThread();
  ServoThread(const ServoThread&) = delete;
  ServoThread& operator=(const ServoThread&) = delete;

  void setSettings(const ServoSettings& settings) noexcept {
    settings_.write(settings);
    heartbeat_.fetch_add(1, std::memory_order_relaxed);
  }

  /// From now on the owner hands settings over at least every kWatchdog_s. While it does not, its panic key is
  /// not heard either, and no force is given.
  void expectSettings() noexcept { expects_.store(true, std::memory_order_relaxed); }
  static constexpr double kWatchdog_s = 1.0;

  /// Hands over the tracker of a scene (null: none), whose number comes back in every sample that this tracker makes.
  /// Settings set before are in force when it is first stepped. The old one comes back and is destroyed here, never on
  /// the loop.
  void setTracker(std::unique_ptr<Tracker> tracker, std::uint32_t scene = 0);

  /// The device to be felt with from now on; null: the fallback. The old one's force goes along the slew, then the loop
  /// stands for some ticks, without force, and the old device is closed here.
  void setDevice(std::unique_ptr<Device> device);
  /// The chosen device, for its info() and status(); null where none is.
  Device* device() const noexcept { return chosen_.get(); }
  /// Whether the fallback stands in, at the newest tick, for a chosen device that is gone.
  bool fallenBack() const noexcept { return fallen_back_.load(std::memory_order_relaxed); }

  /// Lets the force go, along the slew, and gives none from then on; returns when there is none, after kRelease_ms at
  /// the latest. For the program's end, before anything else is done there.
  void endForce();
  static constexpr int kRelease_ms = 50;

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

  /// Records every tick with all that it depended on, from the tick in which the next tracker is handed over, until
  /// false.
  void record(bool on);
  /// Calls take(tick) for each recorded tick since the last call (the last 4 s at most), and tells in `start` the state
  /// that the first began from.
  template <class Take>
  void drainRecording(ServoStep& start, Take&& take) {
    RecordedTick tick;
    while (recording_ && recording_->ring.pop(tick)) {
      start = recording_->start;
      take(tick);
    }
  }
  /// Ticks that were not recorded because nobody drained them in time.
  std::size_t lostOfRecording() const { return recording_ ? recording_->ring.dropped() : 0; }

  /// Whether the loop runs at real-time priority, and if not, why; set soon after the start.
  RealtimeStatus realtime() const noexcept { return realtime_.load(std::memory_order_acquire); }

  /// Ticks that were left out because the loop fell more than kCatchUp_ticks behind.
  std::uint64_t missedTicks() const noexcept { return missed_.load(std::memory_order_relaxed); }

 private:
  static constexpr std::int64_t kPeriod_ns = 1'000'000;
  static constexpr int kCatchUp_ticks = 5;
  // A device with its own clock is left to it while that ticks at least so often.
  static constexpr std::int64_t kOwnClock_ns = 10'000'000;
  void start();
  void release();
  void finish();
  void run() noexcept;
  void tickOfDevice() noexcept override;
  ServoSettings watchedSettings(double dt_s) noexcept;
  // One tick, due at `due_ns`; without it a tick after the last, as a device's own clock counts.
  void tickOnce(std::optional<std::int64_t> due_ns) noexcept;
  void collect();

  Device& fallback_;
  std::unique_ptr<Device> chosen_;
  TripleBuffer<ServoSettings> settings_;
  std::atomic<std::uint32_t> heartbeat_{0};  // how often settings were handed over
  std::atomic<bool> expects_{false};
  TripleBuffer<ServoSample> latest_;
  SampleRing<ServoSample, 4096> samples_;
  // A tracker on its way, with its scene's number; no tracker in it: none is wanted.
  struct Handed {
    std::unique_ptr<Tracker> tracker;
    std::uint32_t scene = 0;
  };
  std::atomic<Handed*> arriving_{nullptr};  // the next
  std::atomic<Handed*> leaving_{nullptr};   // one that the loop has put down
  Handed* current_ = nullptr;               // the loop's
  std::atomic<RealtimeStatus> realtime_{RealtimeStatus::Starting};
  std::atomic<std::uint64_t> missed_{0};
  struct Recording {
    SampleRing<RecordedTick, 4096> ring;
    ServoStep start;       // written before the first tick is pushed
    bool begun = false;    // the loop's: the tracker that it is to begin with is there
    bool started = false;  // the loop's: the state at its first tick is kept
  };
  std::unique_ptr<Recording> recording_;
  std::atomic<bool> records_{false};
  std::atomic<bool> fallen_back_{false};
  std::atomic<bool> stop_{false};
  std::atomic<bool> released_{false};  // no force is wanted: the device is put away
  bool for_good_ = false;              // and no other is to have any
  std::atomic<bool> gives_{false};     // the newest tick gave the chosen device some
  // A tick's own, taken by whoever ticks: the loop's clock or the device's.
  std::atomic_flag ticking_ = ATOMIC_FLAG_INIT;
  std::optional<ServoStep> step_;
  std::optional<DeviceSwitch> switch_;
  TickTime time_;
  std::uint32_t last_heartbeat_ = 0;
  double silent_s_ = 0;
  std::int64_t last_ns_ = 0;
  std::atomic<std::int64_t> device_tick_ns_{0};
  std::thread thread_;
};

}  // namespace moltact
