// A PacketPort over TCP, for a device or a program that listens on a network address and speaks the framing of
// report_stream.h. Threads and waits: as packet/packet_port.h.
#pragma once

#include <memory>

#include "engine/device/packet/packet_port.h"
#include "engine/platform/tcp.h"

namespace moltact {

/// Times of a port, in milliseconds. Connecting and describing are short, because closing a device that is just being
/// reopened waits for them.
namespace tcp_port {
inline constexpr int kConnect_ms = 500;      ///< to make the connection
inline constexpr int kDescription_ms = 500;  ///< to answer a request of the description
inline constexpr int kSilence_ms = 2000;     ///< after this time without a report the device counts as gone
}  // namespace tcp_port

/// Connects. A Problem with the reason.
Expected<std::unique_ptr<PacketPort>> openTcpPort(const TcpAddress& address);

}  // namespace moltact
