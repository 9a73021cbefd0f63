#include "engine/device/driver.h"
#include "engine/device/omni/omni_device.h"
#include "engine/language/catalogue.h"

namespace moltact {
namespace {

void describe(FoundDevice& one, const OmniDevice::Seen& seen) {
  one.usable = true;
  if (!seen.model.empty()) one.title = seen.model;
  if (!seen.serial.empty()) one.place = trf("serial number {0}", seen.serial);
}

std::vector<FoundDevice> findOmnis() {
  FoundDevice one{.title = N_("Phantom Omni or Touch"), .gives_force = true, .auto_selectable = true};
  if (const auto taken = OmniDevice::taken()) {
    describe(one, *taken);
    one.place = one.place.empty() ? tr("in use here") : trf("{0}, in use here", one.place);
  } else if (const auto seen = OmniDevice::look()) {
    describe(one, *seen);
  } else {
    one.why = seen.problem().text();
  }
  return {one};
}

}  // namespace

extern const DeviceDriver kOmniDriver;
const DeviceDriver kOmniDriver{
    .name = "omni",
    .sentence = N_("Phantom Omni, Geomagic Touch and 3D Systems Touch, through OpenHaptics."),
    .find = findOmnis,
    .open = [](const FoundDevice&) -> Expected<std::unique_ptr<Device>> {
      auto device = OmniDevice::open();
      if (!device) return device.problem();
      return std::unique_ptr<Device>(std::move(*device));
    },
};

}  // namespace moltact
