// Devices and programs that speak the open report layout over TCP: docs/device-protocol.md, "Over a network".
#include "engine/device/driver.h"
#include "engine/device/hid/open_layout.h"
#include "engine/device/net/tcp_port.h"
#include "engine/device/packet/packet_device.h"
#include "engine/language/catalogue.h"

namespace moltact {
namespace {

constexpr const char* kTitle = N_("Device of the open layout, over a network");

std::vector<FoundDevice> findAt(std::string_view text) {
  FoundDevice one{.title = kTitle, .place = std::string(text), .gives_force = true};
  const auto refuse = [&](const Problem& problem) {
    one.why = problem.text();
    return std::vector{one};
  };
  const auto address = parseTcpAddress(text);
  if (!address) return refuse(address.problem());
  one.place = address->text();
  const auto port = openTcpPort(*address);
  if (!port) return refuse(port.problem());
  DeviceInfo info;
  if (const auto problem = OpenLayoutProtocol().begin(**port, info)) return refuse(*problem);
  one.gives_force = info.gives_force;
  one.usable = true;
  return {one};
}

// Nothing is looked for: a network address is always named.
std::vector<FoundDevice> find() {
  return {{.title = kTitle,
           .why = tr("name its address: open-tcp:PORT on this computer, open-tcp:HOST:PORT on another"),
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
  return PacketDevice::open(opener, std::make_unique<OpenLayoutProtocol>(), std::move(known));
}

}  // namespace

extern const DeviceDriver kOpenTcpDriver;
const DeviceDriver kOpenTcpDriver{
    .name = "open-tcp",
    .sentence = N_("A device or a program that speaks the reports of docs/device-protocol.md over TCP."),
    .find = find,
    .find_at = findAt,
    .open = open,
};

}  // namespace moltact
