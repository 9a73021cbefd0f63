// Phantom Omni, Geomagic Touch and 3D Systems Touch through OpenHaptics' HD interface (hd_library.h). The maker's
// scheduler is the servo loop's clock: read() and write() run inside its callback, between the frame's begin and end;
// whenever that clock stands, a read from elsewhere gives the last place as stale, and after 100 of them a device that is
// gone. Units: millimetre, newton; the device's axes are the program's.
#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "engine/device/device.h"
#include "engine/device/omni/hd_library.h"

namespace moltact {

class OmniDevice final : public Device {
 public:
  /// Window's thread. Initialises the default device. A Problem in words where there is none or it is in use.
  static Expected<std::unique_ptr<OmniDevice>> open();
  ~OmniDevice() override;

  const DeviceInfo& info() const noexcept override { return info_; }
  DevicePose read(double dt_s) noexcept override;
  void write(ForceN force) noexcept override;

  /// Says what calibration asks of the person and what the driver reported; tries to open a device anew that was lost.
  DeviceStatus status() override;
  void calibrate() override { calibrate_.store(true, std::memory_order_release); }
  bool startClock(TickTarget& target) override;
  void stopClock() override;

  const std::string& model() const { return model_; }
  const std::string& serial() const { return serial_; }
  /// True while a device of this process is open.
  static bool inUse();

 private:
  explicit OmniDevice(const hd::Library& library) : hd_(library) {}
  std::optional<Problem> initialise();
  void schedule();
  void unschedule();
  static hd::CallbackCode callback(void* self);
  hd::CallbackCode frame() noexcept;
  void checkCalibration() noexcept;
  bool drainErrors() noexcept;

  const hd::Library& hd_;
  DeviceInfo info_;
  std::string model_, serial_;
  hd::Handle device_ = hd::kInvalidHandle;
  std::uint32_t calibration_style_ = 0;

  // Of the clock.
  TickTarget* target_ = nullptr;
  hd::SchedulerHandle scheduled_ = 0;
  bool scheduling_ = false;
  std::atomic<bool> ends_{false}, ended_{true};
  std::atomic<std::thread::id> frame_thread_{};

  // Of the callback.
  DevicePose pose_;
  Vec3 force_N_{0.0};
  int frames_ = 0, stale_reads_ = 0, troubled_ticks_ = 0, warm_ticks_ = 0;

  // From the callback to the window.
  std::atomic<std::uint32_t> calibration_{hd::kNeedsManualInput}, last_error_{0}, errors_{0};
  std::atomic<double> motor_heat_{-1.0};
  std::atomic<bool> gone_{false}, calibrate_{false}, in_inkwell_{false};

  // The window's.
  std::uint32_t errors_told_ = 0, error_shown_ = 0;
  std::chrono::steady_clock::time_point shown_until_{}, try_again_{};
};

}  // namespace moltact
