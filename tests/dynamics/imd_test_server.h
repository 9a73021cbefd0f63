// An IMD server on a loopback port, whose atoms move by their forces (0.01 A for each kcal/mol/A and frame) toward
// nothing else: a pulled atom comes to rest where its spring ends. Its own thread serves one client at a time. Linux.
#pragma once

#include <doctest/doctest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "tests/dynamics/imd_bytes.h"

namespace moltact::test {

/// What the server does after some frames, instead of the next one.
enum class ImdFault : std::uint8_t {
  None,
  HangsUp,      ///< closes the connection between two frames
  CutsFrame,    ///< closes it in the middle of a frame
  Resets,       ///< closes it as a killed process with unread bytes does
  Disconnects,  ///< says that the session ends
  Garbage,
  NotANumber,
  TooManyAtoms,
  TwoGigabytes,
  Stalls,  ///< sends nothing more, and keeps the connection
};

class ImdTestServer {
 public:
  ImdTestServer(ImdServerBytes bytes, std::vector<Vec3> at_A) : bytes_(bytes), at_A_(std::move(at_A)) {
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
  ~ImdTestServer() {
    ends_ = true;
    thread_.join();
    ::close(listener_);
  }
  ImdTestServer(const ImdTestServer&) = delete;
  ImdTestServer& operator=(const ImdTestServer&) = delete;

  std::uint16_t port() const { return port_; }

  std::atomic<ImdFault> fault{ImdFault::None};
  std::atomic<int> frames_before_fault{3};  ///< of each client
  std::atomic<std::uint32_t> cut_at{20};    ///< CutsFrame: bytes of the frame that are sent
  std::atomic<int> clients{0}, gone{0};     ///< that came, that went
  std::atomic<int> pushed{0};               ///< atoms with a force at present
  std::atomic<bool> paused{false};
  std::atomic<int> frame_us{1000};
  /// The types and values of the last client's messages.
  std::string words() {
    const std::lock_guard lock(mutex_);
    return wordsOf(heard_);
  }
  /// True if the last client's last word about forces was that there are none.
  bool forceEnded() {
    const std::lock_guard lock(mutex_);
    for (std::size_t k = heard_.size(); k-- > 0;)
      if (heard_[k].type == 6) return heard_[k].value == 0;
    return true;
  }
  bool disconnected() {
    const std::lock_guard lock(mutex_);
    return !heard_.empty() && heard_.back().type == 0;
  }
  Vec3 place_A(std::size_t atom) {
    const std::lock_guard lock(mutex_);
    return at_A_[atom];
  }

 private:
  void run() {
    while (!ends_) {
      pollfd one{listener_, POLLIN, 0};
      if (::poll(&one, 1, 2) <= 0) continue;
      const int client = ::accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
      if (client < 0) continue;
      {
        const std::lock_guard lock(mutex_);
        heard_.clear();
      }
      in_.clear();
      forces_.clear();
      pushed = 0;
      paused = false;
      ++clients;
      serve(client);
      ::close(client);
      pushed = 0;
      ++gone;
    }
  }

  void serve(int client) {
    if (!send(client, bytes_.greeting())) return;
    auto next = std::chrono::steady_clock::now();
    for (int frames = 0; !ends_;) {
      if (!hear(client)) return;
      const std::size_t heard = [&] {
        const std::lock_guard lock(mutex_);
        return heard_.size();
      }();
      if (heard > 0 && !paused) {
        if (fault != ImdFault::None && frames >= frames_before_fault) {
          if (!act(client)) return;
        } else {
          move();
          if (!send(client, frame(frames))) return;
          ++frames;
        }
      }
      next += std::chrono::microseconds(frame_us.load());
      std::this_thread::sleep_until(next);
    }
  }

  Bytes frame(int number) {
    const std::lock_guard lock(mutex_);
    return bytes_.frame(at_A_, 0.02 * number);
  }

  void move() {
    const std::lock_guard lock(mutex_);
    const double unit = bytes_.version == 3 ? 4.184 : 1.0;
    for (const auto& [atom, force] : forces_) at_A_[atom] += force * (0.01 / unit);
  }

  // False: the connection is to be closed.
  bool act(int client) {
    const ImdFault now = fault;
    const std::vector<Vec3> more(at_A_.size() + 1), nowhere(at_A_.size(), Vec3(std::nan("")));
    Bytes bytes;
    switch (now) {
      case ImdFault::None:
      case ImdFault::Stalls:
        return true;
      case ImdFault::HangsUp:
        return false;
      case ImdFault::CutsFrame:
        bytes = frame(0);
        bytes.resize(std::min<std::size_t>(cut_at, bytes.size() - 1));
        send(client, bytes);
        return false;
      case ImdFault::Resets: {
        const linger at_once{1, 0};
        ::setsockopt(client, SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
        return false;
      }
      case ImdFault::Disconnects:
        bytes = ImdServerBytes::header(0, 0);
        break;
      case ImdFault::Garbage:
        for (std::uint32_t k = 0; k < 100; ++k) bytes.push_back(std::uint8_t(97 + cut_at * (k + 1) % 89));
        break;
      case ImdFault::NotANumber:
        bytes = bytes_.places(nowhere);
        break;
      case ImdFault::TooManyAtoms:
        bytes = bytes_.places(more);
        break;
      case ImdFault::TwoGigabytes:
        bytes = ImdServerBytes::header(2, 0x7fffffff);
        break;
    }
    if (!send(client, bytes)) return false;
    // What the client answers, until it closes the connection.
    while (!ends_ && hear(client)) std::this_thread::sleep_for(std::chrono::microseconds(200));
    return false;
  }

  bool hear(int client) {
    std::uint8_t bytes[4096];
    for (;;) {
      const ssize_t size = ::recv(client, bytes, sizeof bytes, MSG_DONTWAIT);
      if (size == 0) return false;
      if (size < 0) return errno == EAGAIN;
      in_.insert(in_.end(), bytes, bytes + size);
      for (ImdSent& sent : takeSent(in_, bytes_.little)) {
        const std::lock_guard lock(mutex_);
        if (sent.type == 6) {
          forces_.clear();
          for (std::size_t k = 0; k < sent.atoms.size(); ++k) {
            REQUIRE(std::size_t(sent.atoms[k]) < at_A_.size());
            forces_.emplace_back(std::size_t(sent.atoms[k]), sent.forces[k]);
          }
          pushed = int(forces_.size());
        }
        if (sent.type == 7) paused = bytes_.version == 3 || !paused;
        if (sent.type == 11) paused = false;
        const bool ends = sent.type == 0;
        heard_.push_back(std::move(sent));
        if (ends) return false;
      }
    }
  }

  static bool send(int client, const Bytes& bytes) {
    return ::send(client, bytes.data(), bytes.size(), MSG_NOSIGNAL) == ssize_t(bytes.size());
  }

  const ImdServerBytes bytes_;
  std::mutex mutex_;
  std::vector<Vec3> at_A_;
  std::vector<ImdSent> heard_;
  Bytes in_;
  std::vector<std::pair<std::size_t, Vec3>> forces_;
  int listener_ = -1;
  std::uint16_t port_ = 0;
  std::atomic<bool> ends_{false};
  std::thread thread_;
};

}  // namespace moltact::test
