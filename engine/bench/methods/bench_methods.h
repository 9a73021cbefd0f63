// The methods that only the bench measures, beside those that the program offers (engine/haptics/methods.h). A new one
// needs its own files and a row in bench_methods.cpp. Any thread.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "engine/haptics/methods.h"

namespace moltact::bench {

/// methods(), followed by the methods for comparison only.
std::span<const Method> benchMethods();

/// Finds a method by name among benchMethods(); nullptr if there is none.
const Method* findBenchMethod(std::string_view name);

/// The restrictions of a method that prepares the whole scene; methods() have none.
struct MethodLimits {
  std::size_t max_spheres = 0;  ///< largest scene that it is measured on; 0: no limit
  bool one_probe = false;       ///< works only with the probe radius given at construction
  /// Represents only what is visible from +z: the chart measures it on the strokes that come from there (bench/trade_off.h).
  bool from_above = false;

  bool none() const { return max_spheres == 0 && !one_probe; }
};
MethodLimits limitsOf(const Method& method);

}  // namespace moltact::bench
