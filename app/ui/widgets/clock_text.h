// Formats times as a clock shows them.
#pragma once

#include <cstdlib>
#include <string>

namespace moltact {

/// Minutes and seconds: "1:05".
inline std::string clockText(int whole_s) {
  const int seconds = std::abs(whole_s % 60);
  return std::to_string(whole_s / 60) + (seconds < 10 ? ":0" : ":") + std::to_string(seconds);
}

}  // namespace moltact
