// A PacketPort over TCP, for a device or a program that listens on a network address and speaks the framing of
// report_stream.h. Threads and waits: as packet/packet_port.h.
#pragma once

#include <memory>

#include "engine/device/packet/packet_port.h"
#include "engine/platform/tcp.h"

namespace moltact {

/// Times of a port, in milliseconds.
namespace tcp_port {
inline constexpr int kConnect_ms = 1000;      ///< for the connection to be made
inline constexpr int kDescription_ms = 1000;  ///< for the answer to a request of the description
inline constexpr int kSilence_ms = 2000;      ///< without a report for so long the device counts as gone
}  // namespace tcp_port

/// Connects. A Problem with the reason.
Expected<std::unique_ptr<PacketPort>> openTcpPort(const TcpAddress& address);

}  // namespace moltact
