// A stylus that listens on a loopback port and speaks the open layout over TCP (docs/device-protocol.md), with the
// reference firmware. Its own thread serves one host at a time. Linux.
#pragma once

#include <doctest/doctest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "engine/device/packet/report_bytes.h"
#include "engine/platform/realtime.h"
#include "tests/device/open_firmware.h"

namespace moltact::test {

class TcpStylus {
 public:
  /// What the stylus sends instead of a complete position report.
  enum class Sends { Places, Nothing, EmptyReport, LongReport, HalfReport };

  TcpStylus() {
    listener_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    REQUIRE(listener_ >= 0);
    sockaddr_in at{};
    at.sin_family = AF_INET;
    at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    REQUIRE(::bind(listener_, reinterpret_cast<sockaddr*>(&at), sizeof at) == 0);
    REQUIRE(::listen(listener_, 4) == 0);
    socklen_t size = sizeof at;
    REQUIRE(::getsockname(listener_, reinterpret_cast<sockaddr*>(&at), &size) == 0);
    port_ = ntohs(at.sin_port);
    thread_ = std::thread([this] { run(); });
  }
  ~TcpStylus() {
    ends_ = true;
    thread_.join();
    ::close(listener_);
  }
  TcpStylus(const TcpStylus&) = delete;
  TcpStylus& operator=(const TcpStylus&) = delete;

  std::string device() const { return "open-tcp:" + std::to_string(port_); }
  std::uint16_t port() const { return port_; }

  std::atomic<Sends> sends{Sends::Places};
  std::atomic<bool> describes{true};   ///< answers the request for its description
  std::atomic<bool> hangs_up{false};   ///< closes the connection
  std::atomic<bool> connected{false};  ///< a host is being served; otherwise the motors are off
  std::atomic<double> x_mm{0.0};
  /// The number of hosts so far and of force reports. The latest force in mN summed over the axes (0 if the motors are
  /// off), its maximum, and the time of the last report with a force (monotonic clock).
  std::atomic<int> hosts{0}, reports{0}, last_mN{0}, greatest_mN{0};
  std::atomic<std::int64_t> forced_ns{0};

 private:
  void run() {
    while (!ends_) {
      pollfd one{listener_, POLLIN, 0};
      if (::poll(&one, 1, 5) <= 0) continue;
      const int host = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
      if (host < 0) continue;
      ++hosts;
      connected = true;
      serve(host);
      ::close(host);
      connected = false;
    }
  }

  void serve(int host) {
    std::vector<std::uint8_t> in;
    auto next = std::chrono::steady_clock::now();
    while (!ends_ && !hangs_up.exchange(false)) {
      next += std::chrono::milliseconds(1);
      if (!sendPlace(host)) return takeRest(host, in);
      do {
        pollfd one{host, POLLIN, 0};
        if (::poll(&one, 1, 1) <= 0) continue;
        std::uint8_t bytes[512];
        const ssize_t size = ::recv(host, bytes, sizeof bytes, 0);
        if (size <= 0) return;
        takeAll(host, in, {bytes, std::size_t(size)});
      } while (std::chrono::steady_clock::now() < next);
    }
  }

  // A host may have sent reports before it disconnected.
  void takeRest(int host, std::vector<std::uint8_t>& in) {
    std::uint8_t bytes[512];
    for (ssize_t size; (size = ::recv(host, bytes, sizeof bytes, MSG_DONTWAIT)) > 0;)
      takeAll(host, in, {bytes, std::size_t(size)});
  }

  void takeAll(int host, std::vector<std::uint8_t>& in, std::span<const std::uint8_t> bytes) {
    in.insert(in.end(), bytes.begin(), bytes.end());
    while (!in.empty() && in.size() > in[0]) {
      take(host, {in.begin() + 1, in.begin() + 1 + in[0]});
      in.erase(in.begin(), in.begin() + 1 + in[0]);
    }
  }

  void take(int host, const std::vector<std::uint8_t>& report) {
    if (report.size() == 1 && report[0] == 3 && describes) {
      const auto description = firmware_.description();
      send(host, description);
    }
    if (report.size() != 11 || report[0] != 2) return;
    firmware_.take(report);
    const std::span<const std::uint8_t> bytes(report);
    const int mN =
        report[9] ? std::abs(int16At(bytes, 3)) + std::abs(int16At(bytes, 5)) + std::abs(int16At(bytes, 7)) : 0;
    last_mN = mN;
    greatest_mN = std::max(greatest_mN.load(), mN);
    if (mN > 0) forced_ns = monotonic_ns();
    ++reports;
  }

  bool sendPlace(int host) {
    const auto place = firmware_.tick({x_mm.load(), 0, 0});
    switch (sends.load()) {
      case Sends::Places:
        return send(host, place);
      case Sends::Nothing:
        return true;
      case Sends::EmptyReport:
        return raw(host, {0});
      case Sends::LongReport:
        return raw(host, {200, 1, 2, 3});
      case Sends::HalfReport:
        return sends.exchange(Sends::Nothing) == Sends::HalfReport && raw(host, {25, 1, 0, 0});
    }
    return false;
  }
  static bool send(int host, std::span<const std::uint8_t> report) {
    std::vector<std::uint8_t> message{static_cast<std::uint8_t>(report.size())};
    message.insert(message.end(), report.begin(), report.end());
    return raw(host, message);
  }
  static bool raw(int host, const std::vector<std::uint8_t>& bytes) {
    return ::send(host, bytes.data(), bytes.size(), MSG_NOSIGNAL) == ssize_t(bytes.size());
  }

  OpenFirmware firmware_;
  int listener_ = -1;
  std::uint16_t port_ = 0;
  std::atomic<bool> ends_{false};
  std::thread thread_;
};

}  // namespace moltact::test
