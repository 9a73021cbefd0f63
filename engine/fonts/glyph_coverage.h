// The characters that the window can display: those of its fonts in scripts from left to right with one glyph per
// character. Used by `moltact check`, which has no window, and by the window to load the required glyphs. Any thread
// except the haptic one.
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
  NoSign,       ///< no font contains it
  NeedsLayout,  ///< its script runs from right to left, or its glyphs change or stack with their neighbours
};

class GlyphCoverage {
 public:
  using Range = std::pair<char32_t, char32_t>;  ///< first and last, both included

  /// Collects the characters of the font files; files that cannot be opened are ignored.
  explicit GlyphCoverage(std::span<const std::filesystem::path> fonts);
  /// The coverage of the window's fonts, Inter and DejaVu Sans. Read once.
  static const GlyphCoverage& ofWindow();

  /// Tests a character. Characters without a glyph (line ends, zero-width characters, a byte order mark) are writable.
  /// If no font could be opened, every character counts as writable.
  Writable writable(char32_t c) const;
  const std::vector<Range>& ranges() const { return ranges_; }

 private:
  std::vector<Range> ranges_;  // ascending and disjoint
};

}  // namespace moltact
