// Parses physical quantities as authors write them: "4 Å", "0.4 nm", "0.3 N", "2 min", "500 N/m", "0.2 N to 0.6 N". A
// number without a unit is an error that lists the possible units. Pure functions; any thread. The code's units: length
// Å, force N, time s, stiffness N/mm.
#pragma once

#include <string_view>

#include "engine/core/problem.h"
#include "engine/language/units.h"

namespace moltact {

/// "a length", "a force", … in English; messages translate it with `tr`.
const char* dimensionName(Dimension dimension);

/// Parses a quantity into the code's unit. `text` must be one finite number and one unit of that dimension, nothing
/// else. A Problem has line 0 and the column within `text`.
Expected<double> parseQuantity(std::string_view text, Dimension dimension);

struct QuantityRange {
  double low = 0.0, high = 0.0;  ///< in the code's unit, low <= high
};

/// Parses "0.2 N to 0.6 N" or "0.2 to 0.6 N". Problems as above.
Expected<QuantityRange> parseRange(std::string_view text, Dimension dimension);

/// Parses a number without a unit, for counts. Problems as above.
Expected<double> parseNumber(std::string_view text);

}  // namespace moltact
