#include "engine/fonts/glyph_coverage.h"

#include <doctest/doctest.h>

using namespace moltact;

TEST_CASE(
    "the window's fonts write Latin, Greek and Cyrillic; not Chinese, Thai or a smiling face, nor Hebrew from the "
    "right") {
  const GlyphCoverage& table = GlyphCoverage::ofWindow();
  REQUIRE_FALSE(table.ranges().empty());
  for (const char32_t c :
       {U'a', U'Z', U'ß', U'Å', U'ő', U'ř', U'ắ', U'α', U'Ω', U'Ж', U'ї', U'≤', U'→', U'₂', U'✓', U'„'})
    CHECK(table.writable(c) == Writable::Yes);
  for (const char32_t c : {U'中', U'あ', U'\U0001F600', U'\U0001F9EC'}) CHECK(table.writable(c) == Writable::NoSign);
  for (const char32_t c : {U'ש', U'ع', U'क', U'ก'}) CHECK(table.writable(c) == Writable::NeedsLayout);
  for (const char32_t c : {U'\n', U'\t', U'\uFEFF', U'\u200B', U'\u00AD', U'\uFE0F'})
    CHECK(table.writable(c) == Writable::Yes);
}

TEST_CASE("ranges are ascending and apart, and without a font nothing is complained of") {
  const GlyphCoverage& table = GlyphCoverage::ofWindow();
  for (std::size_t k = 0; k < table.ranges().size(); ++k) {
    CHECK(table.ranges()[k].first <= table.ranges()[k].second);
    if (k) CHECK(table.ranges()[k - 1].second + 1 < table.ranges()[k].first);
  }
  const std::filesystem::path nowhere[]{"/nowhere/at-all.otf"};
  CHECK(GlyphCoverage(nowhere).writable(U'中') == Writable::Yes);
}
