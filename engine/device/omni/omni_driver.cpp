#include "engine/device/driver.h"
#include "engine/device/omni/omni_device.h"

namespace moltact {
namespace {

// Whether one is plugged in shows only when it is opened: it is opened for the look and closed again.
std::vector<FoundDevice> find() {
  FoundDevice one{.title = "Phantom Omni or Touch", .gives_force = true, .by_itself = true};
  if (OmniDevice::inUse()) {
    one.usable = true;
    one.place = "in use here";
    return {one};
  }
  if (const auto device = OmniDevice::open()) {
    one.usable = true;
    if (!(*device)->model().empty()) one.title = (*device)->model();
    one.place = (*device)->serial().empty() ? "" : "serial number " + (*device)->serial();
  } else {
    one.why = device.problem().text();
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
