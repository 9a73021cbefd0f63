#include <winsock2.h>
#include <ws2tcpip.h>

#include <algorithm>
#include <cstring>
#include <system_error>

#include "engine/language/catalogue.h"
#include "engine/platform/force_inhibit.h"
#include "engine/platform/tcp.h"

namespace moltact {
namespace {

bool started() {
  static const bool ok = [] {
    WSADATA data;
    return WSAStartup(MAKEWORD(2, 2), &data) == 0;
  }();
  return ok;
}

enum class Wait { Readable, Writable };

// select(), because WSAPoll() does not report a failed connection on every version of Windows.
bool waitFor(SOCKET socket, Wait what, int wait_ms) {
  fd_set one, failed;
  FD_ZERO(&one);
  FD_SET(socket, &one);
  failed = one;
  timeval time{wait_ms / 1000, wait_ms % 1000 * 1000};
  const bool reads = what == Wait::Readable;
  return ::select(0, reads ? &one : nullptr, reads ? nullptr : &one, &failed, &time) > 0;
}

// A connection to a port in the range for outgoing connections without a listener can connect to itself.
bool connectedToItself(SOCKET socket) {
  sockaddr_storage own{}, peer{};
  int own_size = sizeof own, peer_size = sizeof peer;
  return ::getsockname(socket, reinterpret_cast<sockaddr*>(&own), &own_size) == 0 &&
         ::getpeername(socket, reinterpret_cast<sockaddr*>(&peer), &peer_size) == 0 && own_size == peer_size &&
         std::memcmp(&own, &peer, std::size_t(own_size)) == 0;
}

class Connection final : public TcpConnection {
 public:
  explicit Connection(SOCKET socket) : socket_(socket) {}
  ~Connection() override {
    act_.disarm();
    ::closesocket(socket_);
  }

  int read(std::span<std::uint8_t> into, int wait_ms) override {
    if (!waitFor(socket_, Wait::Readable, wait_ms)) return 0;
    const int size = ::recv(socket_, reinterpret_cast<char*>(into.data()), int(into.size()), 0);
    if (size > 0) return size;
    return size < 0 && WSAGetLastError() == WSAEWOULDBLOCK ? 0 : -1;
  }

  bool write(std::span<const std::uint8_t> bytes) override {
    while (!bytes.empty()) {
      const int size = ::send(socket_, reinterpret_cast<const char*>(bytes.data()), int(bytes.size()), 0);
      if (size > 0) {
        bytes = bytes.subspan(std::size_t(size));
        continue;
      }
      if (WSAGetLastError() != WSAEWOULDBLOCK || !waitFor(socket_, Wait::Writable, kMaxWriteWait_ms)) return false;
    }
    return true;
  }

  bool lastBytes(std::span<const std::uint8_t> bytes) override {
    act_.disarm();
    if (bytes.size() > sizeof last_) return false;
    last_size_ = int(bytes.size());
    std::copy(bytes.begin(), bytes.end(), last_);
    return act_.arm(
        [](void* self) noexcept {  // the socket does not block
          const Connection& me = *static_cast<const Connection*>(self);
          return ::send(me.socket_, reinterpret_cast<const char*>(me.last_), me.last_size_, 0) != SOCKET_ERROR ||
                 ::WSAGetLastError() != WSAEWOULDBLOCK;
        },
        this);
  }

 private:
  const SOCKET socket_;
  std::uint8_t last_[kMaxLastBytes] = {};
  int last_size_ = 0;
  LastAct act_;  // the last member, so that its destructor runs first
};

}  // namespace

Expected<std::unique_ptr<TcpConnection>> TcpConnection::connect(const TcpAddress& address, int timeout_ms) {
  const auto refuse = [&](const std::string& reason) {
    return Problem{"", 0, 0, trf("there is no connection to {0}: {1}", address.text(), reason),
                   tr("start the program or device that listens there, and check the address")};
  };
  const auto reasonOf = [](int error) { return std::system_category().message(error); };
  if (!started()) return refuse("WSAStartup");
  addrinfo hints{};
  hints.ai_flags = AI_NUMERICHOST;
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const std::string port = std::to_string(address.port);
  if (const int error = ::getaddrinfo(address.host.c_str(), port.c_str(), &hints, &found))
    return refuse(reasonOf(error));
  const SOCKET socket = ::socket(found->ai_family, SOCK_STREAM, IPPROTO_TCP);
  int error = socket == INVALID_SOCKET ? WSAGetLastError() : 0;
  u_long on = 1;
  const int buffer = kSendBuffer_bytes;
  if (!error) ::setsockopt(socket, SOL_SOCKET, SO_SNDBUF, reinterpret_cast<const char*>(&buffer), sizeof buffer);
  if (!error) ::ioctlsocket(socket, FIONBIO, &on);
  if (!error && ::connect(socket, found->ai_addr, int(found->ai_addrlen)) != 0) {
    error = WSAGetLastError();
    if (error == WSAEWOULDBLOCK) {
      int size = sizeof error;
      if (!waitFor(socket, Wait::Writable, timeout_ms))
        error = WSAETIMEDOUT;
      else
        ::getsockopt(socket, SOL_SOCKET, SO_ERROR, reinterpret_cast<char*>(&error), &size);
    }
  }
  ::freeaddrinfo(found);
  if (!error && connectedToItself(socket)) error = WSAECONNREFUSED;
  if (error) {
    if (socket != INVALID_SOCKET) ::closesocket(socket);
    return refuse(reasonOf(error));
  }
  const BOOL no_delay = TRUE;
  ::setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, reinterpret_cast<const char*>(&no_delay), sizeof no_delay);
  return std::unique_ptr<TcpConnection>(std::make_unique<Connection>(socket));
}

}  // namespace moltact
