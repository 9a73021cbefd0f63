#include <arpa/inet.h>
#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <climits>

#include "engine/platform/local_addresses.h"

namespace moltact {

LocalAddresses localAddresses() {
  LocalAddresses out;
  ifaddrs* first = nullptr;
  if (::getifaddrs(&first) == 0) {
    for (const ifaddrs* one = first; one; one = one->ifa_next) {
      if (!one->ifa_addr || one->ifa_addr->sa_family != AF_INET) continue;
      if (!(one->ifa_flags & IFF_UP) || (one->ifa_flags & IFF_LOOPBACK)) continue;
      std::array<char, INET_ADDRSTRLEN> text{};
      const auto* address = reinterpret_cast<const sockaddr_in*>(one->ifa_addr);
      if (!::inet_ntop(AF_INET, &address->sin_addr, text.data(), text.size())) continue;
      if (std::find(out.ip.begin(), out.ip.end(), text.data()) == out.ip.end()) out.ip.emplace_back(text.data());
    }
    ::freeifaddrs(first);
  }
  std::array<char, HOST_NAME_MAX + 1> name{};
  if (::gethostname(name.data(), name.size() - 1) == 0) out.host = name.data();
  return out;
}

}  // namespace moltact
