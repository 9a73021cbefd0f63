// Values of scene keys that have a syntax of their own: the modes of an elastic molecule, a scanning tip. Problems have
// line 0 and a column within the text. Any thread.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "engine/core/problem.h"

namespace moltact {

/// "1, 3": numbers from 1 (the softest) to kElasticModes, returned from 0, ascending, each once. "all": an empty list.
Expected<std::vector<std::size_t>> parseModes(std::string_view text);

struct ScanValue {
  double tip_A = 0.0;     ///< 0 to kMaxSceneTip_A
  double force_pN = 0.0;  ///< 0: contact without force; to kMaxScanForce_pN
};

/// The largest radius of a tip in a scene.
inline constexpr double kMaxSceneTip_A = 20.0;

/// "10 Å", "10 Å, 100 pN".
Expected<ScanValue> parseScan(std::string_view text);

}  // namespace moltact
