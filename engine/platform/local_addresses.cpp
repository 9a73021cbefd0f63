#include "engine/platform/local_addresses.h"

#include <algorithm>

namespace moltact {

LocalAddresses addressesForOthers(const std::vector<InterfaceAddress>& interfaces, const std::string& route) {
  LocalAddresses out;
  for (const InterfaceAddress& one : interfaces) {
    if (!one.carrier || one.alone) continue;
    std::vector<std::string>& into = one.bridge && one.ip != route ? out.bridges : out.ip;
    if (std::find(into.begin(), into.end(), one.ip) == into.end()) into.push_back(one.ip);
  }
  if (const auto best = std::find(out.ip.begin(), out.ip.end(), route); best != out.ip.end())
    std::rotate(out.ip.begin(), best, best + 1);
  return out;
}

}  // namespace moltact
