// Phantom Omni, Geomagic Touch and 3D Systems Touch through OpenHaptics' HD interface (hd_library.h). The vendor's
// scheduler is the servo loop's clock: read() and write() run inside its callback, between the frame's begin and end.
// While that clock is stalled, a read from another thread returns the last position as stale, and after 100 such reads
// a disconnected device. A device that is lost or stalled is reopened on a separate thread.
//
// Its last frames give no force, however they end: by an error, the end of the clock or a signal. If frames stop or
// fail, a guard switches the output off (omni_guard.h). Units: millimetre, newton; the device's axes are the program's.
#pragma once

#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "engine/core/triple_buffer.h"
#include "engine/device/device.h"
#include "engine/device/omni/omni_guard.h"
#include "engine/device/omni/omni_session.h"
#include "engine/device/versioned_device_info.h"
#include "engine/platform/force_inhibit.h"
#include "engine/platform/realtime.h"

namespace moltact {

class OmniDevice final : public Device {
 public:
  /// Initialises the default device, or takes over the one that look() has opened. Returns a Problem if there is none
  /// or it is in use. Not for the haptic thread; may block for some seconds.
  static Expected<std::unique_ptr<OmniDevice>> open(std::int64_t (*now_ns)() noexcept = &monotonic_ns);
  /// Identifies the device that open() would return. Only an open device reports this, so look() keeps the device open
  /// for a moment.
  struct Seen {
    std::string model, serial;
  };
  static Expected<Seen> look();
  /// Identifies the device that is open in this process, if any.
  static std::optional<Seen> taken();
  ~OmniDevice() override;

  const DeviceInfo& info() const noexcept override { return info_.get(); }
  DevicePose read(double dt_s) noexcept override;
  void write(ForceN force) noexcept override;

  /// Reports what the calibration requires of the user and what the driver reported. Starts to reopen a device that was
  /// lost. Never blocks.
  DeviceStatus status() override;
  void calibrate() override { calibrate_.store(true, std::memory_order_release); }
  bool startClock(ClockListener& target) override;
  void stopClock() override;

  const std::string& model() const { return session_.model; }
  const std::string& serial() const { return session_.serial; }
  /// Closes immediately a device that look() has opened, so that another program can use it.
  static void closeUnused();

 private:
  OmniDevice(const hd::Library& library, OmniSession session, std::int64_t (*now_ns)() noexcept);
  void schedule();
  void unschedule();
  void revive();
  void takeRevived();
  void finishRevival();
  bool lost() const noexcept;
  std::string guidance(DeviceStatus& status) const;
  static hd::CallbackCode callback(void* self);
  hd::CallbackCode frame() noexcept;
  void tickFrame(bool ends) noexcept;
  void writeZeroForce() noexcept;
  /// A summary of the driver's error stack.
  struct Drained {
    bool lost = false;         ///< the device or its clock is lost
    bool fails_frame = false;  ///< the frame that caused them was not written
  };
  Drained drain() noexcept;
  bool endFrame(const Vec3& force_N, bool failed) noexcept;
  static bool lastAct(void* self) noexcept;
  void begin() noexcept;
  void look(bool now) noexcept;
  void checkCalibration(bool may_update) noexcept;
  bool note(std::uint32_t worst) noexcept;

  const hd::Library& hd_;
  VersionedDeviceInfo info_;
  // Owned by the window's thread; while revival_ is valid, exclusively by its thread.
  OmniSession session_;
  hd::SchedulerHandle scheduled_ = 0;
  bool scheduling_ = false;
  std::future<Expected<OmniSession>> revival_;

  // From the window to the callback. Style and handle change only while there is no callback.
  std::atomic<ClockListener*> target_{nullptr};
  std::atomic<hd::Handle> handle_{hd::kInvalidHandle};
  std::atomic<std::uint32_t> calibration_style_{0};
  Vec3 workspace_middle_mm_{0.0};  // written while no frame runs
  std::atomic<bool> anew_{false}, ends_{false}, ended_{true}, calibrate_{false};

  // Used only by the callback.
  struct OfCallback {
    DevicePose pose;
    Vec3 force_N{0.0};
    int frames = 0, fault_ticks = 0, warm_ticks = 0, resetting_ticks = 0;
    bool begin_failed = false;  // of the open frame
    bool broken = false;        // the device is lost: only frames without force, until the window closes it
  } own_;

  // From the callback to the loop's own clock.
  TripleBuffer<DevicePose> last_pose_;
  std::atomic<std::thread::id> frame_thread_{};
  std::atomic<int> stalled_reads_{0};  // reads from other threads since the last frame
  std::atomic<bool> framed_{false};    // a frame has arrived since the clock was started

  // From the callback to the window.
  std::atomic<std::uint32_t> calibration_{hd::kNeedsManualInput}, worst_error_{hd::kNoError}, lost_by_{hd::kNoError};
  std::atomic<double> motor_heat_{-1.0};
  std::atomic<bool> gone_{false}, in_inkwell_{false}, resetting_{false}, reset_failed_{false};

  // Used only by the window.
  std::uint32_t error_shown_ = hd::kNoError;
  std::string why_not_;  // reason for the failure of the last revival
  std::chrono::steady_clock::time_point shown_until_{}, try_again_{};

  std::atomic<bool> none_given_{true};  // the newest frame accepted by the driver gave no force
  OmniGuard guard_;
  LastAct last_act_;  // declared last, so that it is destroyed first
};

}  // namespace moltact
