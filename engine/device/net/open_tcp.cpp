// Devices and programs with the open report layout over TCP: docs/device-protocol.md, "Over a network".
#include "engine/device/driver.h"
#include "engine/device/hid/open_layout.h"
#include "engine/device/net/tcp_port.h"
#include "engine/device/packet/packet_device.h"
#include "engine/language/catalogue.h"

namespace moltact {
namespace {

constexpr const char* kTitle = N_("Device of the open layout, over a network");
constexpr const char* kLost = N_("{0}: the connection is lost. The program tries to connect again.");

FoundDevice findAt(std::string_view text) {
  FoundDevice out{.title = kTitle, .place = std::string(text), .gives_force = true};
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

// There is no search: the user gives the address.
std::vector<FoundDevice> findOpenTcp() {
  return {{.title = kTitle,
           .why = tr("give its address: open-tcp:PORT on this computer, open-tcp:HOST:PORT on another"),
           .gives_force = true}};
}

Expected<std::unique_ptr<Device>> open(const FoundDevice& found) {
  const auto address = parseTcpAddress(found.place);
  if (!address) return address.problem();
  DeviceInfo known;
  known.name = kTitle;
  known.gives_force = true;
  const auto opener = [at = *address](const PacketDevice::Accept& accept) -> Expected<std::unique_ptr<PacketPort>> {
    auto port = openTcpPort(at);
    if (!port) return port;
    if (auto problem = accept(**port)) return *problem;
    return port;
  };
  return PacketDevice::open(opener, std::make_unique<OpenLayoutProtocol>(), std::move(known), true, kLost);
}

}  // namespace

extern const DeviceDriver kOpenTcpDriver;
const DeviceDriver kOpenTcpDriver{
    .name = "open-tcp",
    .sentence = N_("A device or a program that speaks the reports of docs/device-protocol.md over TCP."),
    .find = findOpenTcp,
    .find_at = findAt,
    .address_example = "127.0.0.1:7010",
    .open = open,
};

}  // namespace moltact
