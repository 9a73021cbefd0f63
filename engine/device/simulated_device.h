// A simulated force-feedback stylus: the device model (device_model.h) in the scripted hand, or in a hand that a test
// leads. The loop through it is closed: the written force moves it. Haptic thread unless stated otherwise.
#pragma once

#include <atomic>
#include <memory>

#include "engine/device/device.h"
#include "engine/device/device_model.h"
#include "engine/device/scripted_hand.h"

namespace moltact {

/// The scripted hand explores a point this far behind the middle of the device's workspace, for a molecule lies in
/// front of that point.
inline constexpr double kSimulatedTargetDepth_mm = 45.0;

class SimulatedDevice final : public Device {
 public:
  explicit SimulatedDevice(const DeviceParameters& device = {}, const HandParameters& hand = {});
  ~SimulatedDevice() override { write(ForceN{}); }

  const DeviceInfo& info() const noexcept override { return info_; }
  DevicePose read(double dt_s) noexcept override;
  /// Advances the model by a tick.
  void write(ForceN force) noexcept override;
  DeviceStatus status() override;

  /// The model; it outlives the device for whoever holds it. Read it only while nothing ticks.
  std::shared_ptr<const DeviceModel> model() const { return model_; }

  /// Any thread: pulls the plug, or puts it back. The hand goes on meanwhile, without force.
  void plug(bool in) noexcept { plugged_.store(in, std::memory_order_release); }

 private:
  DeviceInfo info_;
  std::shared_ptr<DeviceModel> model_;
  ScriptedHand hand_;
  std::atomic<bool> plugged_{true};
};

/// The description of a device with these parameters.
DeviceInfo describe(const DeviceParameters& device);

}  // namespace moltact
