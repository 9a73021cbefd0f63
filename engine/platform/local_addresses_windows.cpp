#include <winsock2.h>
#include <ws2tcpip.h>
// clang-format off: needs the two above
#include <iphlpapi.h>
// clang-format on

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "engine/platform/local_addresses.h"

namespace moltact {
namespace {

std::string textOf(const SOCKADDR* address) {
  std::array<char, INET_ADDRSTRLEN> text{};
  const auto* v4 = reinterpret_cast<const sockaddr_in*>(address);
  return ::inet_ntop(AF_INET, &v4->sin_addr, text.data(), text.size()) ? text.data() : std::string();
}

// The address from which this computer reaches others beyond its network; empty if it reaches none. Connecting a datagram
// socket chooses the interface and sends nothing. 192.0.2.1 is nobody's (RFC 5737).
std::string addressOfDefaultRoute() {
  const SOCKET handle = ::socket(AF_INET, SOCK_DGRAM, 0);
  if (handle == INVALID_SOCKET) return {};
  sockaddr_in to{}, own{};
  to.sin_family = AF_INET;
  to.sin_port = htons(9);
  to.sin_addr.s_addr = htonl(0xC0000201);
  int size = sizeof own;
  const bool known = ::connect(handle, reinterpret_cast<const sockaddr*>(&to), sizeof to) == 0 &&
                     ::getsockname(handle, reinterpret_cast<sockaddr*>(&own), &size) == 0;
  ::closesocket(handle);
  return known ? textOf(reinterpret_cast<const SOCKADDR*>(&own)) : std::string();
}

// Windows names no bridge as such. Its virtual switches for machines and subsystems have this name in every language.
bool virtualSwitch(const wchar_t* name) {
  return name && std::wstring_view(name).find(L"vEthernet") != std::wstring_view::npos;
}

std::vector<InterfaceAddress> interfaceAddresses() {
  constexpr ULONG kWithout = GAA_FLAG_SKIP_ANYCAST | GAA_FLAG_SKIP_MULTICAST | GAA_FLAG_SKIP_DNS_SERVER;
  constexpr ULONG kMaxBytes = 1 << 20;
  std::vector<InterfaceAddress> out;
  ULONG bytes = 16 << 10;  // as its documentation suggests; a longer list asks for more
  ULONG answer = ERROR_BUFFER_OVERFLOW;
  std::vector<std::max_align_t> room;
  IP_ADAPTER_ADDRESSES* first = nullptr;
  for (int k = 0; k < 3 && answer == ERROR_BUFFER_OVERFLOW && bytes <= kMaxBytes; ++k) {
    room.resize(bytes / sizeof(std::max_align_t) + 1);
    first = reinterpret_cast<IP_ADAPTER_ADDRESSES*>(room.data());
    answer = ::GetAdaptersAddresses(AF_INET, kWithout, nullptr, first, &bytes);
  }
  if (answer != NO_ERROR) return out;
  for (const IP_ADAPTER_ADDRESSES* one = first; one; one = one->Next)
    for (const auto* address = one->FirstUnicastAddress; address; address = address->Next) {
      const std::string ip = textOf(address->Address.lpSockaddr);
      if (ip.empty()) continue;
      out.push_back(
          {ip, one->OperStatus == IfOperStatusUp,
           one->IfType == IF_TYPE_SOFTWARE_LOOPBACK || one->IfType == IF_TYPE_PPP || one->IfType == IF_TYPE_TUNNEL,
           virtualSwitch(one->FriendlyName)});
    }
  return out;
}

}  // namespace

LocalAddresses localAddresses() {
  WSADATA data;
  if (::WSAStartup(MAKEWORD(2, 2), &data) != 0) return {};
  LocalAddresses out = addressesForOthers(interfaceAddresses(), addressOfDefaultRoute());
  std::array<char, 256> name{};
  if (::gethostname(name.data(), int(name.size()) - 1) == 0) out.host = name.data();
  ::WSACleanup();
  return out;
}

}  // namespace moltact
