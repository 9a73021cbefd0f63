#include "engine/fonts/glyph_coverage.h"

#include <ft2build.h>
#include FT_FREETYPE_H

#include <algorithm>
#include <array>
#include <string>

#include "engine/fonts/font_files.h"

namespace moltact {
namespace {

// The window's characters have 16 bits.
constexpr char32_t kMax = 0xFFFF;

// Hebrew to Arabic extended, the scripts of India, Thai and Lao, Tibetan, Burmese, Khmer, Mongolian, presentation
// forms.
constexpr std::array<GlyphCoverage::Range, 9> kNeedLayout{{{0x0590, 0x08FF},
                                                           {0x0900, 0x0DFF},
                                                           {0x0E00, 0x0EFF},
                                                           {0x0F00, 0x0FFF},
                                                           {0x1000, 0x109F},
                                                           {0x1780, 0x17FF},
                                                           {0x1800, 0x18AF},
                                                           {0xFB1D, 0xFDFF},
                                                           {0xFE70, 0xFEFE}}};

bool within(std::span<const GlyphCoverage::Range> ranges, char32_t c) {
  const auto at = std::upper_bound(ranges.begin(), ranges.end(), c,
                                   [](char32_t v, const GlyphCoverage::Range& r) { return v < r.first; });
  return at != ranges.begin() && c <= std::prev(at)->second;
}

bool unseen(char32_t c) {
  return c < 0x20 || c == 0x7F || c == 0xAD || (c >= 0x200B && c <= 0x200F) || c == 0x2060 || c == 0xFEFF ||
         (c >= 0xFE00 && c <= 0xFE0F);
}

}  // namespace

GlyphCoverage::GlyphCoverage(std::span<const std::filesystem::path> fonts) {
  FT_Library library = nullptr;
  if (FT_Init_FreeType(&library) != 0) return;
  std::vector<char32_t> all;
  for (const std::filesystem::path& file : fonts) {
    FT_Face face = nullptr;
    if (FT_New_Face(library, file.string().c_str(), 0, &face) != 0) continue;
    FT_UInt glyph = 0;
    if (FT_Select_Charmap(face, FT_ENCODING_UNICODE) == 0)
      for (FT_ULong c = FT_Get_First_Char(face, &glyph); glyph != 0; c = FT_Get_Next_Char(face, c, &glyph))
        all.push_back(char32_t(c));
    FT_Done_Face(face);
  }
  FT_Done_FreeType(library);
  std::sort(all.begin(), all.end());
  for (const char32_t c : all)
    if (!ranges_.empty() && c <= ranges_.back().second + 1)
      ranges_.back().second = std::max(ranges_.back().second, c);
    else
      ranges_.emplace_back(c, c);
}

const GlyphCoverage& GlyphCoverage::ofWindow() {
  static const std::array<std::filesystem::path, 2> kFonts{interFile("Inter-Regular.otf"), dejaVuFile()};
  static const GlyphCoverage table(kFonts);
  return table;
}

Writable GlyphCoverage::writable(char32_t c) const {
  if (ranges_.empty() || unseen(c)) return Writable::Yes;
  if (within(kNeedLayout, c)) return Writable::NeedsLayout;
  return c <= kMax && within(ranges_, c) ? Writable::Yes : Writable::NoSign;
}

}  // namespace moltact
