// Determines the size of a PNG's inflated rows without storing them, because a file of a few kilobytes can contain
// gigabytes of zeros. Any thread but the haptic one.
#pragma once

#include <cstddef>
#include <string_view>

namespace moltact {

enum class PngRows {
  Fit,      ///< at most the picture's size requires, or the rows end early
  TooMany,  ///< more than the picture's size requires
  Damaged,  ///< cannot be inflated, or the file gives no size
};

/// Reads the header and every IDAT chunk. Inflates into a small buffer and stops as soon as there are too many rows.
/// Accepts any bytes that begin with the PNG signature.
PngRows inflatedRows(std::string_view png);

}  // namespace moltact
