// The address in a scene's `simulation: imd://HOST:PORT`, of a simulation in another program. Any thread except the
// haptic one.
#pragma once

#include <optional>
#include <string_view>

#include "engine/core/problem.h"
#include "engine/platform/tcp.h"

namespace moltact {

/// Nothing for the name of a file. A Problem without a place if the text begins like an address and is none.
std::optional<Expected<TcpAddress>> imdAddress(std::string_view simulation);

}  // namespace moltact
