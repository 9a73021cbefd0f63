// Devices that exchange reports over TCP: what their drivers (engine/device/driver.h) have in common. A driver is a
// TcpDeviceKind and three functions that pass it on, as open_tcp.cpp shows. Threads: as in driver.h.
#pragma once

#include <memory>
#include <string_view>

#include "engine/device/driver.h"
#include "engine/device/net/report_framing.h"
#include "engine/device/packet/packet_protocol.h"

namespace moltact {

struct TcpDeviceKind {
  const char* title;        ///< of its devices, untranslated (N_)
  std::string_view driver;  ///< DeviceDriver::name
  const ReportFraming& (*framing)();
  std::unique_ptr<PacketProtocol> (*protocol)();
  bool gives_force = true;
};

/// For DeviceDriver::find: one entry that is not usable and gives the syntax of an address, because nothing is searched
/// for.
std::vector<FoundDevice> unsearchedTcpDevice(const TcpDeviceKind& kind);
/// For DeviceDriver::find_at: PORT, HOST:PORT or [IPv6]:PORT.
FoundDevice tcpDeviceAt(const TcpDeviceKind& kind, std::string_view address);
/// For DeviceDriver::open.
Expected<std::unique_ptr<Device>> openTcpDevice(const TcpDeviceKind& kind, const FoundDevice& found);

}  // namespace moltact
