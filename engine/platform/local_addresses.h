// The names under which other computers of the network reach this one. Any thread but the haptic one.
#pragma once

#include <string>
#include <vector>

namespace moltact {

struct LocalAddresses {
  std::vector<std::string>
      ip;  ///< IPv4 addresses of the interfaces that have a carrier, that of the default route first, without the
           ///< loopback and connections to one other computer: "192.168.1.5"
  std::string host;  ///< the computer's own name: "laptop"; empty if it has none
};

LocalAddresses localAddresses();

}  // namespace moltact
