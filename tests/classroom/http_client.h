// A client that asks one thing per connection, with headers and bodies that no library would send.
#pragma once

#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <string>

namespace moltact::test {

struct HttpAnswer {
  int status = 0;  ///< 0: the connection broke
  std::string body;
};

/// Sends bytes and reads until the server closes, `until` has come, or ten seconds have passed.
inline HttpAnswer httpRaw(std::uint16_t port, const std::string& request, const std::string& until = "") {
  HttpAnswer out;
  const int at = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_port = htons(port);
  to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const timeval patience{10, 0};
  ::setsockopt(at, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  ::setsockopt(at, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
  std::string answer;
  if (::connect(at, reinterpret_cast<const sockaddr*>(&to), sizeof to) == 0) {
    for (std::size_t sent = 0; sent < request.size();) {
      const ssize_t some = ::send(at, request.data() + sent, request.size() - sent, MSG_NOSIGNAL);
      if (some <= 0) break;  // a server that refuses may close before all is sent
      sent += std::size_t(some);
    }
    std::array<char, 16384> part;
    while (until.empty() || answer.find(until) == std::string::npos) {
      const ssize_t got = ::recv(at, part.data(), part.size(), 0);
      if (got <= 0) break;
      answer.append(part.data(), std::size_t(got));
    }
  }
  ::close(at);
  if (answer.starts_with("HTTP/1.1 ") && answer.size() > 12) out.status = std::atoi(answer.c_str() + 9);
  const std::size_t head = answer.find("\r\n\r\n");
  if (head != std::string::npos) out.body = answer.substr(head + 4);
  return out;
}

inline HttpAnswer httpAsk(std::uint16_t port, const std::string& method, const std::string& path,
                          const std::string& body = "", const std::string& headers = "",
                          const std::string& until = "") {
  std::string request = method + " " + path + " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port) + "\r\n" + headers;
  if (method != "GET") request += "Content-Length: " + std::to_string(body.size()) + "\r\n";
  return httpRaw(port, request + "\r\n" + body, until);
}

}  // namespace moltact::test
