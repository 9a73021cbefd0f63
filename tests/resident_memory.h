// The memory of this program that is in use, for tests of what it keeps. Linux; empty elsewhere.
#pragma once

#include <cstddef>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>

namespace moltact::test {

struct ResidentMemory {
  double now_MB = 0.0;   ///< resident
  double peak_MB = 0.0;  ///< the most since the start of the program or since forgetPeak()
};

inline std::optional<ResidentMemory> residentMemory() {
  std::ifstream file("/proc/self/status");
  std::optional<double> now, peak;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line);
    std::string name;
    double kB = 0.0;
    if (!(words >> name >> kB)) continue;
    if (name == "VmRSS:") now = kB / 1024.0;
    if (name == "VmHWM:") peak = kB / 1024.0;
  }
  if (!now || !peak) return std::nullopt;
  return ResidentMemory{*now, *peak};
}

/// The peak becomes the present value. Returns false where the system refuses.
inline bool forgetPeak() {
  std::ofstream file("/proc/self/clear_refs");
  return static_cast<bool>(file << "5" << std::flush);
}

}  // namespace moltact::test
