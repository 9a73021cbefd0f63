// Injects faults between a device and the loop: ticks that are late, doubled or lost, a stalled loop, misread
// positions. Judges every force that the device then receives (force_monitor.h). It supplies the clock if the device
// has none, so that it controls the ticks. One thread injects; the loop's thread executes. Units: millimetre, newton.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <thread>

#include "engine/device/device.h"
#include "engine/servo/force_monitor.h"
#include "engine/servo/loop_fault.h"

namespace moltact {

class FaultyDevice final : public Device, private ClockListener {
 public:
  explicit FaultyDevice(std::unique_ptr<Device> device);
  ~FaultyDevice() override { stopClock(); }

  /// Injects a fault for `ticks` ticks (for Stall: milliseconds), one at a time. Late delays each tick by 0 to 14 ms;
  /// PositionJump shifts by 20 mm.
  void inject(LoopFault fault, int ticks);
  bool faultIsOver() const { return fault_.load() == LoopFault::None; }

  /// A summary of the forces since the last call.
  struct Given {
    const char* broken = nullptr;  ///< the first violated guarantee; null: none
    std::uint64_t ticks = 0;
    std::uint64_t fresh = 0;  ///< ticks with a fresh position from the device itself
    double peak_N = 0;
    double last_N = 0;  ///< the newest force
  };
  Given given();

  const DeviceInfo& info() const noexcept override { return device_->info(); }
  DevicePose read(double dt_s) noexcept override;
  void write(ForceN force) noexcept override;
  void writeWrench(const Wrench& wrench) noexcept override;
  void stop() noexcept override;
  DeviceStatus status() override { return device_->status(); }
  ViewMotion viewMotion() noexcept override { return device_->viewMotion(); }
  void calibrate() override { device_->calibrate(); }
  bool startClock(ClockListener& target) override;
  void stopClock() override;

 private:
  void onDeviceTick() noexcept override;
  void run() noexcept;
  void tick() noexcept;
  bool misread(DevicePose& pose) noexcept;
  void note(const Vec3& force_N, bool stopped) noexcept;
  void passed() noexcept;

  std::unique_ptr<Device> device_;
  std::atomic<LoopFault> fault_{LoopFault::None};
  std::atomic<int> left_{0};

  // Used by the clock.
  std::atomic<ClockListener*> target_{nullptr};
  std::atomic<bool> ends_{false};
  bool lent_ = false;  // the device's own clock supplies the ticks
  std::thread clock_;
  int late_ = 0;

  // Used by the tick.
  ForceMonitor judge_;
  ForceMonitor::Tick now_;
  const DeviceInfo* judged_ = nullptr;
  bool was_connected_ = true, was_bad_ = false, stood_ = false;

  std::atomic<const char*> broken_{nullptr};
  std::atomic<std::uint64_t> ticks_{0}, fresh_{0};
  std::atomic<double> peak_N_{0.0}, last_N_{0.0};
};

}  // namespace moltact
