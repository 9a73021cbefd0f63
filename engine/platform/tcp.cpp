// The part of tcp.h that is the same on every system: addresses.
#include "engine/platform/tcp.h"

#include <charconv>

#include "engine/language/catalogue.h"

namespace moltact {

std::string TcpAddress::text() const {
  const std::string number = std::to_string(port);
  return host.find(':') == std::string::npos ? host + ':' + number : '[' + host + "]:" + number;
}

bool TcpAddress::loopback() const { return host.starts_with("127.") || host == "::1"; }

Expected<TcpAddress> parseTcpAddress(std::string_view text) {
  const auto refuse = [&] {
    return Problem{
        "", 0, 0, trf("\"{0}\" is not a network address", text),
        tr("write PORT or HOST:PORT with a numeric host, for example 7010, 192.168.1.20:7010 or [::1]:7010")};
  };
  TcpAddress out;
  std::string_view port = text;
  if (text.starts_with('[')) {
    const std::size_t end = text.find("]:");
    if (end == std::string_view::npos) return refuse();
    out.host = text.substr(1, end - 1);
    port = text.substr(end + 2);
    if (out.host.find(':') == std::string::npos) return refuse();
  } else if (const std::size_t colon = text.find(':'); colon != std::string_view::npos) {
    out.host = text.substr(0, colon);
    port = text.substr(colon + 1);
    if (out.host == "localhost") out.host = "127.0.0.1";
  }
  const bool numeric = !out.host.empty() && out.host.find_first_not_of("0123456789abcdefABCDEF:.") == std::string::npos;
  const auto [end, error] = std::from_chars(port.data(), port.data() + port.size(), out.port);
  if (!numeric || error != std::errc{} || end != port.data() + port.size() || out.port == 0) return refuse();
  return out;
}

}  // namespace moltact
