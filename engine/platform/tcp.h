// TCP connections to devices and to other programs. Linux and Windows; in a page in a browser none can be made. Every
// call states how long it may wait. For threads that own a device or a simulation and for commands, never for the haptic thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "engine/core/problem.h"

namespace moltact {

/// A numeric IP address and a port.
struct TcpAddress {
  std::string host = "127.0.0.1";
  std::uint16_t port = 0;

  /// "127.0.0.1:7010", "192.168.1.20:7010" or "[::1]:7010".
  std::string text() const;
  /// True for an address on this computer: 127.x.x.x or ::1. Data to any other address cross a network.
  bool loopback() const;
};

/// Parses PORT, HOST:PORT or [IPv6]:PORT. The host is a numeric address or `localhost`; without one it is 127.0.0.1.
/// Names of other computers are refused, because looking them up can block for longer than any time-out here.
Expected<TcpAddress> parseTcpAddress(std::string_view text);

/// One connection, used by one thread at a time.
class TcpConnection {
 public:
  /// The peer must accept written bytes within this time. Otherwise the connection counts as gone.
  static constexpr int kMaxWriteWait_ms = 20;

  /// The system's send buffer. It is small, so that a peer that stops reading is noticed and does not later receive
  /// old reports.
  static constexpr int kSendBuffer_bytes = 4096;

  /// Connects within `timeout_ms`. A Problem contains the address and the system's reason.
  static Expected<std::unique_ptr<TcpConnection>> connect(const TcpAddress& address, int timeout_ms);
  virtual ~TcpConnection() = default;

  /// Reads received bytes into `into`. Returns their number; 0: none arrived within `wait_ms`; -1: the connection is
  /// gone.
  virtual int read(std::span<std::uint8_t> into, int wait_ms) = 0;
  /// Writes all of `bytes`. False: the connection is gone.
  virtual bool write(std::span<const std::uint8_t> bytes) = 0;
  /// Stores up to kMaxLastBytes, which are sent when the process dies and no thread can write any more
  /// (platform/force_inhibit.h). False: they could not be stored.
  virtual bool lastBytes(std::span<const std::uint8_t> bytes) = 0;
  static constexpr std::size_t kMaxLastBytes = 128;
};

}  // namespace moltact
