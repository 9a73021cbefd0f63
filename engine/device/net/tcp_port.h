// A PacketPort over TCP, for a device or a program that listens on a network address. Threads and blocking as in
// packet/packet_port.h.
#pragma once

#include <memory>

#include "engine/device/net/report_framing.h"
#include "engine/device/packet/packet_port.h"
#include "engine/platform/tcp.h"

namespace moltact {

/// Time limits of a port in milliseconds. Connecting and describing are short, because closing a device that is being
/// reopened waits for them.
namespace tcp_port {
inline constexpr int kConnect_ms = 500;      ///< for establishing the connection
inline constexpr int kDescription_ms = 500;  ///< for the answer to a request of the description
inline constexpr int kSilence_ms = 2000;     ///< without a report for this time the device counts as disconnected
}  // namespace tcp_port

/// Connects. `framing` divides the stream into reports and must outlive the port. A Problem contains the reason.
Expected<std::unique_ptr<PacketPort>> openTcpPort(const TcpAddress& address, const ReportFraming& framing);

}  // namespace moltact
