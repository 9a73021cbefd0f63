#include "engine/device/simulated_device.h"

#include "engine/device/driver.h"
#include "engine/language/catalogue.h"

namespace moltact {

DeviceInfo describe(const DeviceParameters& device) {
  DeviceInfo info{phantomOmniFigures()};
  info.name = N_("Simulated stylus");
  info.dof_in = 6;
  info.dof_out = 6;
  info.workspace_mm = Vec3(2 * ScriptedHand::kAway_mm + 40.0);  // its hand starts farther away than an Omni reaches
  info.max_force_N = device.max_force_N;
  info.max_torque_N_mm = device.max_torque_N_mm;
  info.rotational_damping_N_mm_s = device.rotational_damping_N_mm_s;
  info.damping_N_s_per_m = device.damping_N_s_per_m;
  info.friction_N = device.friction_N;
  info.resolution_mm = device.resolution_mm;
  info.delay_s = device.delay_ticks * device.tick_s;
  info.gives_force = true;
  return info;
}

SimulatedDevice::SimulatedDevice(const DeviceParameters& device, const HandParameters& hand)
    : info_(describe(device)),
      model_(std::make_shared<DeviceModel>(device, hand, ScriptedHand().place(), ScriptedHand().orientation())) {}

DevicePose SimulatedDevice::read(double) noexcept {
  return {.position = {model_->sensed().mm - Vec3(0, 0, kSimulatedTargetDepth_mm)},
          .connected = plugged_.load(std::memory_order_acquire),
          .orientation = model_->orientation()};
}

void SimulatedDevice::writeWrench(const Wrench& wrench) noexcept {
  const bool in = plugged_.load(std::memory_order_acquire);
  const PointMm target = hand_.lead(0.001, model_->held());
  model_->tick(in ? wrench : Wrench{}, target, hand_.orientation());
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
        [] {
          const DeviceParameters model;
          return std::vector{FoundDevice{.title = N_("Simulated stylus"),
                                         .usable = true,
                                         .gives_force = true,
                                         .max_torque_N_mm = model.max_torque_N_mm,
                                         .rotational_damping_N_mm_s = model.rotational_damping_N_mm_s}};
        },
    .open = [](const FoundDevice&) -> Expected<std::unique_ptr<Device>> {
      return std::unique_ptr<Device>(std::make_unique<SimulatedDevice>());
    },
};

}  // namespace moltact
