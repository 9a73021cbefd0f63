// HID devices through hidapi, or in a browser through WebHID: their list, and a port to one.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/problem.h"
#include "engine/device/packet/packet_port.h"

namespace moltact {

/// One interface of a HID device in the system's list.
struct HidEntry {
  std::string path = {};   ///< "/dev/hidraw0"
  std::string title = {};  ///< maker and product, as the device reports them
  std::string serial = {};
  std::uint16_t vendor = 0, product = 0, usage_page = 0, usage = 0;
};

/// Lists all HID interfaces. Any thread.
std::vector<HidEntry> listHid();
/// Opens a port. A Problem contains the reason, usually a missing permission, and the remedy.
Expected<std::unique_ptr<PacketPort>> openHid(const HidEntry& entry);

}  // namespace moltact
