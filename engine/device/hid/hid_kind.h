// One kind of HID device as described by its driver: which entries of the system's list belong to it, and their
// protocol. Window's thread and commands; listing requests each device's description.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "engine/device/driver.h"
#include "engine/device/hid/hid_port.h"
#include "engine/device/packet/packet_device.h"

namespace moltact {

struct HidKind {
  std::string_view title;                         ///< used if the device does not report a title
  bool (*is)(const HidEntry&);                    ///< true if an entry of the system's list may be of this kind
  std::unique_ptr<PacketProtocol> (*protocol)();  ///< creates the protocol
  DeviceInfo known;                               ///< without a name, which is the title of the found device
};

/// Lists the devices of the kind and requests the description of each. Those that cannot be opened come last, with the
/// reason.
std::vector<FoundDevice> findHid(const HidKind& kind);

/// Opens the device that `found` describes. After an unplugging it reconnects to any device of the same kind.
Expected<std::unique_ptr<Device>> openHid(const HidKind& kind, const FoundDevice& found);

}  // namespace moltact
