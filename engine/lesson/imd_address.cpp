#include "engine/lesson/imd_address.h"

namespace moltact {

std::optional<Expected<TcpAddress>> imdAddress(std::string_view simulation) {
  constexpr std::string_view kScheme = "imd://";
  if (!simulation.starts_with(kScheme)) return std::nullopt;
  return parseTcpAddress(simulation.substr(kScheme.size()));
}

}  // namespace moltact
