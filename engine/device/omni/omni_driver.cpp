#include "engine/device/driver.h"
#include "engine/device/omni/omni_device.h"

namespace moltact {
namespace {

std::vector<FoundDevice> find() {
  FoundDevice one{.title = "Phantom Omni or Touch", .gives_force = true, .by_itself = true};
  if (OmniDevice::inUse()) {
    one.usable = true;
    one.place = "in use here";
    return {one};
  }
  if (const auto seen = OmniDevice::look()) {
    one.usable = true;
    if (!seen->model.empty()) one.title = seen->model;
    one.place = seen->serial.empty() ? "" : "serial number " + seen->serial;
  } else {
    one.why = seen.problem().text();
  }
  return {one};
}

}  // namespace

extern const DeviceDriver kOmniDriver;
const DeviceDriver kOmniDriver{
    .name = "omni",
    .sentence = "Phantom Omni, Geomagic Touch and 3D Systems Touch, through OpenHaptics.",
    .find = find,
    .open = [](const FoundDevice&) -> Expected<std::unique_ptr<Device>> {
      auto device = OmniDevice::open();
      if (!device) return device.problem();
      return std::unique_ptr<Device>(std::move(*device));
    },
};

}  // namespace moltact
