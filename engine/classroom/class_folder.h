// The name of a new class's folder. Pure; any thread but the haptic one.
#pragma once

#include <chrono>
#include <string>

#include "engine/results/attempt.h"

namespace moltact {

/// "2026-11-28-061449", of the time in UTC.
inline std::string classFolderName(std::chrono::system_clock::time_point time) {
  std::string out;
  for (const char c : utcText(time))
    if (c == 'T')
      out += '-';
    else if (c != ':' && c != 'Z')
      out += c;
  return out;
}

}  // namespace moltact
