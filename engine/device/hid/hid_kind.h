// One kind of HID device, as its driver describes it: which entries of the system's list are of this kind, and which
// protocol they speak. Window's thread and commands; listing asks each device for its description.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "engine/device/driver.h"
#include "engine/device/hid/hid_port.h"
#include "engine/device/packet/packet_device.h"

namespace moltact {

struct HidKind {
  std::string_view title;                         ///< where the device does not report its own
  bool (*is)(const HidEntry&);                    ///< judges by the system's list alone: the entry may be of this kind
  std::unique_ptr<PacketProtocol> (*protocol)();  ///< makes a new one
  DeviceInfo known;                               ///< without a name: it is the title of the device that was found
};

/// One entry for each device of the kind; each is asked for its description. Those that cannot be opened come last, with
/// the reason.
std::vector<FoundDevice> findHid(const HidKind& kind);

/// Opens the device that `found` describes. After it was unplugged, it looks for a device of the same kind again.
Expected<std::unique_ptr<Device>> openHid(const HidKind& kind, const FoundDevice& found);

}  // namespace moltact
