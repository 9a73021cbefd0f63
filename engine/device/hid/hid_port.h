// HID devices through hidapi, or in a page through WebHID: a list of them, and a port to one.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/problem.h"
#include "engine/device/packet/packet_port.h"

namespace moltact {

/// One interface of a HID device as the system lists it.
struct HidEntry {
  std::string path = {};   ///< "/dev/hidraw0"
  std::string title = {};  ///< maker and product, as the device reports them
  std::string serial = {};
  std::uint16_t vendor = 0, product = 0, usage_page = 0, usage = 0;
};

/// All HID interfaces that the system lists. Any thread.
std::vector<HidEntry> listHid();
/// Opens a port to one. A Problem with the reason, most often a missing permission, and how to get it.
Expected<std::unique_ptr<PacketPort>> openHid(const HidEntry& entry);

}  // namespace moltact
