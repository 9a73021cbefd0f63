#include "engine/device/simulated_device.h"

#include "engine/device/driver.h"
#include "engine/language/catalogue.h"

namespace moltact {

DeviceInfo describe(const DeviceParameters& device) {
  DeviceInfo info{phantomOmniFigures()};
  info.name = N_("Simulated stylus");
  info.dof_in = 6;
  info.dof_out = 3;
  info.workspace_mm = Vec3(2 * ScriptedHand::kAway_mm + 40.0);  // its hand starts farther away than an Omni reaches
  info.max_force_N = device.max_force_N;
  info.damping_N_s_per_m = device.damping_N_s_per_m;
  info.friction_N = device.friction_N;
  info.resolution_mm = device.resolution_mm;
  info.delay_s = device.delay_ticks * device.tick_s;
  info.gives_force = true;
  return info;
}

SimulatedDevice::SimulatedDevice(const DeviceParameters& device, const HandParameters& hand)
    : info_(describe(device)), model_(std::make_shared<DeviceModel>(device, hand, ScriptedHand().place())) {}

DevicePose SimulatedDevice::read(double) noexcept {
  return {.position = {model_->sensed().mm - Vec3(0, 0, kSimulatedTargetDepth_mm)},
          .connected = plugged_.load(std::memory_order_acquire),
          .orientation = hand_.orientation()};
}

void SimulatedDevice::write(ForceN force) noexcept {
  if (!plugged_.load(std::memory_order_acquire)) force = {};
  model_->tick(force, hand_.lead(0.001, model_->held()));
}

DeviceStatus SimulatedDevice::status() {
  DeviceStatus status;
  status.connected = plugged_.load(std::memory_order_acquire);
  if (!status.connected) status.text = tr("The simulated stylus is unplugged.");
  return status;
}

extern const DeviceDriver kSimulatedDriver;
const DeviceDriver kSimulatedDriver{
    .name = "simulated",
    .sentence = N_("A simulated stylus in a hand that feels its way round the molecule: for demonstrations and tests."),
    .find =
        [] { return std::vector{FoundDevice{.title = N_("Simulated stylus"), .usable = true, .gives_force = true}}; },
    .open = [](const FoundDevice&) -> Expected<std::unique_ptr<Device>> {
      return std::unique_ptr<Device>(std::make_unique<SimulatedDevice>());
    },
};

}  // namespace moltact
