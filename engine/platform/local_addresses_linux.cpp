#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <climits>
#include <filesystem>

#include "engine/platform/local_addresses.h"

namespace moltact {
namespace {

// The address from which this computer reaches others beyond its network; empty if it reaches none. Connecting a datagram
// socket chooses the interface and sends nothing. 192.0.2.1 is nobody's (RFC 5737).
std::string addressOfDefaultRoute() {
  const int handle = ::socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (handle < 0) return {};
  sockaddr_in to{}, own{};
  to.sin_family = AF_INET;
  to.sin_port = htons(9);
  to.sin_addr.s_addr = htonl(0xC0000201);
  socklen_t size = sizeof own;
  std::array<char, INET_ADDRSTRLEN> text{};
  const bool known = ::connect(handle, reinterpret_cast<const sockaddr*>(&to), sizeof to) == 0 &&
                     ::getsockname(handle, reinterpret_cast<sockaddr*>(&own), &size) == 0 &&
                     ::inet_ntop(AF_INET, &own.sin_addr, text.data(), text.size());
  ::close(handle);
  return known ? text.data() : std::string();
}

}  // namespace

LocalAddresses localAddresses() {
  std::vector<InterfaceAddress> interfaces;
  ifaddrs* first = nullptr;
  if (::getifaddrs(&first) == 0) {
    for (const ifaddrs* one = first; one; one = one->ifa_next) {
      if (!one->ifa_addr || one->ifa_addr->sa_family != AF_INET) continue;
      std::array<char, INET_ADDRSTRLEN> text{};
      const auto* address = reinterpret_cast<const sockaddr_in*>(one->ifa_addr);
      if (!::inet_ntop(AF_INET, &address->sin_addr, text.data(), text.size())) continue;
      std::error_code error;
      interfaces.push_back(
          {text.data(), (one->ifa_flags & IFF_UP) && (one->ifa_flags & IFF_RUNNING),
           (one->ifa_flags & (IFF_LOOPBACK | IFF_POINTOPOINT)) != 0,
           std::filesystem::exists("/sys/class/net/" + std::string(one->ifa_name) + "/bridge", error)});
    }
    ::freeifaddrs(first);
  }
  LocalAddresses out = addressesForOthers(interfaces, addressOfDefaultRoute());
  std::array<char, HOST_NAME_MAX + 1> name{};
  if (::gethostname(name.data(), name.size() - 1) == 0) out.host = name.data();
  return out;
}

}  // namespace moltact
