#include "engine/device/net/tcp_device.h"

#include "engine/device/net/tcp_port.h"
#include "engine/device/packet/packet_device.h"
#include "engine/language/catalogue.h"

namespace moltact {
namespace {

constexpr const char* kLost = N_("{0}: the connection is lost. The program tries to connect again.");

}  // namespace

std::vector<FoundDevice> unsearchedTcpDevice(const TcpDeviceKind& kind) {
  return {{.title = kind.title,
           .why = trf("give its address: {0}:PORT on this computer, {0}:HOST:PORT on another", kind.driver),
           .gives_force = kind.gives_force}};
}

FoundDevice tcpDeviceAt(const TcpDeviceKind& kind, std::string_view text) {
  FoundDevice out{.title = kind.title, .place = std::string(text), .gives_force = kind.gives_force};
  const auto address = parseTcpAddress(text);
  if (!address) {
    out.why = address.problem().text();
    return out;
  }
  out.place = address->text();
  out.usable = true;
  if (!address->loopback())
    out.note =
        trf("Positions and forces cross the network to {0} unencrypted. Use a network that you trust.", out.place);
  return out;
}

Expected<std::unique_ptr<Device>> openTcpDevice(const TcpDeviceKind& kind, const FoundDevice& found) {
  const auto address = parseTcpAddress(found.place);
  if (!address) return address.problem();
  DeviceInfo known;
  known.name = kind.title;
  known.gives_force = kind.gives_force;
  const auto opener = [at = *address, framing = kind.framing](
                          const PacketDevice::Accept& accept) -> Expected<std::unique_ptr<PacketPort>> {
    auto port = openTcpPort(at, framing());
    if (!port) return port;
    if (auto problem = accept(**port)) return *problem;
    return port;
  };
  return PacketDevice::open(opener, kind.protocol(), std::move(known), true, kLost);
}

}  // namespace moltact
