// The names under which other computers of the network reach this one. Any thread but the haptic one.
#pragma once

#include <string>
#include <vector>

namespace moltact {

struct LocalAddresses {
  std::vector<std::string>
      ip;            ///< IPv4 addresses of the network interfaces in use, without the loopback: "192.168.1.5"
  std::string host;  ///< the computer's own name: "laptop"; empty if it has none
};

LocalAddresses localAddresses();

}  // namespace moltact
