// The names under which other computers of the network reach this one. Any thread but the haptic one.
#pragma once

#include <string>
#include <vector>

namespace moltact {

struct LocalAddresses {
  std::vector<std::string> ip;       ///< IPv4 addresses for others, that of the default route first: "192.168.1.5"
  std::vector<std::string> bridges;  ///< addresses that only virtual machines and containers of this computer reach
  std::string host;                  ///< the computer's own name: "laptop"; empty if it has none
};

LocalAddresses localAddresses();

/// An IPv4 address of an interface of this computer.
struct InterfaceAddress {
  std::string ip;
  bool carrier = true;  ///< up, with a link: an unplugged cable and a bridge without members have none
  bool alone = false;   ///< the loopback, or a connection to one other computer
  bool bridge = false;  ///< joins interfaces, as those of virtual machines and containers do
};

/// What of these others reach. A bridge is one of them if the default route, whose address is `route`, leads over it; it then
/// has the network's cable among its members. `host` stays empty.
LocalAddresses addressesForOthers(const std::vector<InterfaceAddress>& interfaces, const std::string& route);

}  // namespace moltact
