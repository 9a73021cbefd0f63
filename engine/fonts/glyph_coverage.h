// Which characters the window can write: those of its fonts whose script is laid out from left to right, one sign a
// character. For `moltact check`, which has no window, and for the window, which loads the signs that it needs. Any
// thread but the haptic one.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace moltact {

enum class Writable {
  Yes,
  NoSign,       ///< no font has it
  NeedsLayout,  ///< a script that is written from right to left, or whose signs change or stack with their neighbours
};

class GlyphCoverage {
 public:
  using Range = std::pair<char32_t, char32_t>;  ///< the last included

  /// The characters of the font files that can be opened.
  explicit GlyphCoverage(std::span<const std::filesystem::path> fonts);
  /// The window's: Inter and DejaVu Sans. Read once.
  static const GlyphCoverage& ofWindow();

  /// A character that is no sign of its own (line ends, zero-width characters, a byte order mark) is writable. Where no
  /// font could be opened, every character counts as writable.
  Writable writable(char32_t c) const;
  const std::vector<Range>& ranges() const { return ranges_; }

 private:
  std::vector<Range> ranges_;  // ascending, apart
};

}  // namespace moltact
