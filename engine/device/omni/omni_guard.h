// Ends the force of an Omni where its callback cannot. Its own thread wakes 250 times a second and checks whether
// frames come. It switches the driver's force output off when none has come for kStalled_ms, and on again, with a soft
// start, when they do. The callback switches the output off where a frame fails; the guard's thread switches it on again
// after two frames without error. While all force is inhibited (platform/force_inhibit.h) it waits for kStalledInhibited_ms only.
#pragma once

#include <atomic>
#include <cstdint>
#include <thread>

#include "engine/device/omni/hd_library.h"
#include "engine/platform/realtime.h"

namespace moltact {

class OmniGuard {
 public:
  static constexpr int kStalled_ms = 20;  ///< as late as the safety stage lets a tick be
  static constexpr int kStalledInhibited_ms = 5;

  /// `now_ns`: the clock that frames are late by; any thread.
  OmniGuard(const hd::Library& library, std::int64_t (*now_ns)() noexcept) : hd_(library), now_ns_(now_ns) {}
  ~OmniGuard() { stop(); }

  /// The thread that schedules. Frames may come from now on.
  void start();
  /// The same: nothing is asked of the driver after it returns.
  void stop();
  /// The callback: a frame begins.
  void frame() noexcept;
  /// The callback: the driver has taken the frame without error.
  void written() noexcept { clean_frames_.fetch_add(1, std::memory_order_acq_rel); }
  /// Switches the output off until two frames have been written without error. The callback, its signal handler, or any
  /// thread while no callback runs.
  void switchOff() noexcept;
  /// Any thread: the output is off, or was on for less than two frames, so that only no force is to be written.
  bool cut() const noexcept { return cut_.load(std::memory_order_acquire); }
  /// Any thread: the motors are off whatever force was written last. Never true where the library has no hdDisable.
  bool off() const noexcept { return cut() && hd_.disable; }

 private:
  void run() noexcept;
  void look() noexcept;

  const hd::Library& hd_;
  std::int64_t (*const now_ns_)() noexcept;
  std::atomic<std::int64_t> last_ns_{0};
  std::atomic<std::uint32_t> clean_frames_{0};  // since the output was switched off
  std::atomic<std::uint32_t> failures_{0};      // calls of switchOff()
  std::atomic<bool> cut_{false}, ends_{false};
  std::thread thread_;
};

}  // namespace moltact
