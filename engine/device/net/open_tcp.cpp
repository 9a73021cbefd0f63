// Devices and programs with the open report layout over TCP: docs/device-protocol.md, "Over a network".
#include "engine/device/hid/open_layout.h"
#include "engine/device/net/tcp_device.h"
#include "engine/language/catalogue.h"

namespace moltact {
namespace {

constexpr TcpDeviceKind kKind{
    .title = N_("Device of the open layout, over a network"),
    .driver = "open-tcp",
    .framing = &lengthFraming,
    .protocol = []() -> std::unique_ptr<PacketProtocol> { return std::make_unique<OpenLayoutProtocol>(); },
};

}  // namespace

extern const DeviceDriver kOpenTcpDriver;
const DeviceDriver kOpenTcpDriver{
    .name = kKind.driver,
    .sentence = N_("A device or a program that speaks the reports of docs/device-protocol.md over TCP."),
    .find = [] { return unsearchedTcpDevice(kKind); },
    .find_at = [](std::string_view address) { return tcpDeviceAt(kKind, address); },
    .address_example = "127.0.0.1:7010",
    .open = [](const FoundDevice& found) { return openTcpDevice(kKind, found); },
};

}  // namespace moltact
