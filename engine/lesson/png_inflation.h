// What the compressed rows of a PNG file inflate to, found without keeping them: a file of a few kilobytes can hold
// gigabytes of zeros. Any thread but the haptic one.
#pragma once

#include <cstddef>
#include <string_view>

namespace moltact {

enum class PngRows {
  Fit,      ///< no more than the size of the picture needs, or the rows end early
  TooMany,  ///< more than the size needs
  Damaged,  ///< they cannot be inflated, or the file has no size
};

/// Looks at the header and at every IDAT part. Inflates in a small buffer, and stops as soon as the rows are too many.
/// Takes any bytes that begin with the signature of PNG.
PngRows inflatedRows(std::string_view png);

}  // namespace moltact
