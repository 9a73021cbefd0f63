// A simulated force-feedback stylus with three forces and three torques: the device model (device_model.h) held by the
// scripted hand. The written force moves it and the torque turns it, which closes the loop. Haptic thread unless stated
// otherwise.
#pragma once

#include <atomic>
#include <memory>

#include "engine/device/device.h"
#include "engine/device/device_model.h"
#include "engine/device/scripted_hand.h"

namespace moltact {

/// The scripted hand explores a point this far behind the middle of the device's workspace, because a molecule lies in
/// front of that point.
inline constexpr double kSimulatedTargetDepth_mm = 45.0;

class SimulatedDevice final : public Device {
 public:
  explicit SimulatedDevice(const DeviceParameters& device = {}, const HandParameters& hand = {});
  ~SimulatedDevice() override { write(ForceN{}); }

  const DeviceInfo& info() const noexcept override { return info_; }
  DevicePose read(double dt_s) noexcept override;
  /// Advances the model by one tick.
  void write(ForceN force) noexcept override { writeWrench({force, Vec3(0.0)}); }
  void writeWrench(const Wrench& wrench) noexcept override;
  DeviceStatus status() override;

  /// The model, which may outlive the device. Read it only while no tick runs.
  std::shared_ptr<const DeviceModel> model() const { return model_; }

  /// Any thread: unplugs the device, or plugs it in again. The hand continues meanwhile without force.
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
