#include "engine/device/driver.h"
#include "engine/device/mouse_device.h"
#include "engine/language/catalogue.h"

namespace moltact {

extern const DeviceDriver kMouseDriver;
const DeviceDriver kMouseDriver{
    .name = "mouse",
    .sentence = N_("The mouse or keyboard as a hand: always there, gives no force."),
    .find = [] { return std::vector{FoundDevice{.title = N_("Mouse"), .usable = true, .auto_selectable = true}}; },
    .open = [](const FoundDevice&) -> Expected<std::unique_ptr<Device>> {
      return std::unique_ptr<Device>(std::make_unique<MouseDevice>());
    },
};

}  // namespace moltact
