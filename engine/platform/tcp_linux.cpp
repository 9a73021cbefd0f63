#include <fcntl.h>
#include <linux/sockios.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstring>

#include "engine/language/catalogue.h"
#include "engine/platform/force_inhibit.h"
#include "engine/platform/tcp.h"

namespace moltact {
namespace {

// Waits for the events. A signal that interrupts the wait does not shorten it.
bool waitFor(int socket, short events, int wait_ms) {
  using Clock = std::chrono::steady_clock;
  const auto until = Clock::now() + std::chrono::milliseconds(wait_ms);
  for (;;) {
    pollfd one{socket, events, 0};
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(until - Clock::now()).count();
    const int ready = ::poll(&one, 1, int(std::clamp<long long>(left, 0, wait_ms)));
    if (ready > 0) return true;
    if (ready == 0 || errno != EINTR) return false;
  }
}

// A connection to a port in the range for outgoing connections without a listener can connect to itself.
bool connectedToItself(int socket) {
  sockaddr_storage own{}, peer{};
  socklen_t own_size = sizeof own, peer_size = sizeof peer;
  return ::getsockname(socket, reinterpret_cast<sockaddr*>(&own), &own_size) == 0 &&
         ::getpeername(socket, reinterpret_cast<sockaddr*>(&peer), &peer_size) == 0 && own_size == peer_size &&
         std::memcmp(&own, &peer, own_size) == 0;
}

class Connection final : public TcpConnection {
 public:
  explicit Connection(int socket) : socket_(socket) {}
  ~Connection() override {
    act_.disarm();
    ::close(socket_);
  }

  int read(std::span<std::uint8_t> into, int wait_ms) override {
    if (!waitFor(socket_, POLLIN, wait_ms)) return 0;
    const ssize_t size = ::recv(socket_, into.data(), into.size(), 0);
    // A peer that collects small packets (Nagle's algorithm) sends the next one when this one is acknowledged, which the
    // system would put off for 40 ms. The system forgets the option, so it is set each time.
    const int on = 1;
    ::setsockopt(socket_, IPPROTO_TCP, TCP_QUICKACK, &on, sizeof on);
    if (size > 0) return int(size);
    return size < 0 && (errno == EAGAIN || errno == EINTR) ? 0 : -1;
  }

  bool write(std::span<const std::uint8_t> bytes) override {
    const Writing writing(writer_);
    // The last act sends the last report. An error here would close the connection before that report has left.
    if (forceEnded()) return true;
    while (!bytes.empty()) {
      const ssize_t size = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (size > 0) {
        bytes = bytes.subspan(std::size_t(size));
        continue;
      }
      if (size < 0 && errno == EINTR) continue;
      if (errno != EAGAIN || !waitFor(socket_, POLLOUT, kMaxWriteWait_ms)) return false;
    }
    return true;
  }

  bool lastBytes(std::span<const std::uint8_t> bytes) override {
    act_.disarm();
    if (bytes.size() > sizeof last_) return false;
    last_size_ = bytes.size();
    std::copy(bytes.begin(), bytes.end(), last_);
    // In a signal handler, where send(), gettid() and ioctl() are safe. The act is repeated while endForce() waits, until the
    // report has been sent. The buffer is full until the peer's system has acknowledged about ten reports; data left in
    // it when the process ends are lost.
    return act_.arm(
        [](void* self) noexcept {
          Connection& me = *static_cast<Connection*>(self);
          // A report that another thread is sending must not follow the last one.
          if (const pid_t writer = me.writer_.load(); writer != 0 && writer != ::gettid()) return false;
          if (!me.last_written_.exchange(true) &&
              ::send(me.socket_, me.last_, me.last_size_, MSG_NOSIGNAL | MSG_DONTWAIT) < 0) {
            me.last_written_ = false;
            return errno != EAGAIN && errno != EINTR;
          }
          int unsent_bytes = 0;
          if (::ioctl(me.socket_, SIOCOUTQNSD, &unsent_bytes) == 0 && unsent_bytes > 0) return false;
          me.last_written_ = false;
          return true;
        },
        this);
  }

 private:
  // Names the thread that sends, before it looks whether the force has ended.
  struct Writing {
    explicit Writing(std::atomic<pid_t>& thread) : writer(thread) { writer.exchange(::gettid()); }
    ~Writing() { writer.store(0); }
    std::atomic<pid_t>& writer;
  };

  const int socket_;
  std::atomic<pid_t> writer_{0};
  std::uint8_t last_[kMaxLastBytes] = {};
  std::size_t last_size_ = 0;
  std::atomic<bool> last_written_{false};
  LastAct act_;  // the last member, so that its destructor runs first
};

}  // namespace

Expected<std::unique_ptr<TcpConnection>> TcpConnection::connect(const TcpAddress& address, int timeout_ms) {
  const auto refuse = [&](const std::string& reason) {
    return Problem{"", 0, 0, trf("there is no connection to {0}: {1}", address.text(), reason),
                   tr("start the program or device that listens there, and check the address")};
  };
  addrinfo hints{};
  hints.ai_flags = AI_NUMERICHOST | AI_NUMERICSERV;
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  const std::string port = std::to_string(address.port);
  if (const int error = ::getaddrinfo(address.host.c_str(), port.c_str(), &hints, &found))
    return refuse(::gai_strerror(error));
  const int socket = ::socket(found->ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  const int buffer = kSendBuffer_bytes;
  if (socket >= 0) ::setsockopt(socket, SOL_SOCKET, SO_SNDBUF, &buffer, sizeof buffer);
  int error = socket < 0 ? errno : 0;
  if (!error && ::connect(socket, found->ai_addr, found->ai_addrlen) != 0) {
    error = errno;
    if (error == EINPROGRESS) {
      socklen_t size = sizeof error;
      if (!waitFor(socket, POLLOUT, timeout_ms))
        error = ETIMEDOUT;
      else
        ::getsockopt(socket, SOL_SOCKET, SO_ERROR, &error, &size);
    }
  }
  ::freeaddrinfo(found);
  if (!error && connectedToItself(socket)) error = ECONNREFUSED;
  if (error) {
    if (socket >= 0) ::close(socket);
    return refuse(std::strerror(error));
  }
  const int on = 1;
  ::setsockopt(socket, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
  return std::unique_ptr<TcpConnection>(std::make_unique<Connection>(socket));
}

}  // namespace moltact
