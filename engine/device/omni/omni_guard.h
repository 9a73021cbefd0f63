// Ends the force of an Omni when its callback cannot. A separate thread wakes 250 times a second and checks that frames
// arrive. It switches the driver's force output off when none has arrived for kStalled_ms, and on again, with a soft
// start, when frames return. The callback switches the output off when a frame fails; the guard's thread switches it on
// again after two frames without error. While all force is inhibited (platform/force_inhibit.h) the limit is
// kStalledInhibited_ms.
#pragma once

#include <atomic>
#include <cstdint>
#include <thread>

#include "engine/device/omni/hd_library.h"
#include "engine/platform/realtime.h"

namespace moltact {

class OmniGuard {
 public:
  static constexpr int kStalled_ms = 20;  ///< equal to the lateness that the safety stage accepts
  static constexpr int kStalledInhibited_ms = 5;

  /// `now_ns`: the clock for the lateness of frames; called on any thread.
  OmniGuard(const hd::Library& library, std::int64_t (*now_ns)() noexcept) : hd_(library), now_ns_(now_ns) {}
  ~OmniGuard() { stop(); }

  /// On the scheduling thread: frames may arrive from now on.
  void start();
  /// On the scheduling thread: after its return the driver is no longer called.
  void stop();
  /// In the callback: a frame begins.
  void frame() noexcept;
  /// In the callback: the driver has accepted the frame without error.
  void written() noexcept { clean_frames_.fetch_add(1, std::memory_order_acq_rel); }
  /// Switches the output off until two frames have been written without error. In the callback, its signal handler, or
  /// on any thread while no callback runs.
  void switchOff() noexcept;
  /// Any thread: the output is off, or has been on for less than two frames; only zero force may be written.
  bool cut() const noexcept { return cut_.load(std::memory_order_acquire); }
  /// Any thread: the motors are off, whatever force was written last. Never true for a library without hdDisable.
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
