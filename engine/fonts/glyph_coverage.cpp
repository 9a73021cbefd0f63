#include "engine/fonts/glyph_coverage.h"

#include <ft2build.h>
#include FT_FREETYPE_H

#include <algorithm>
#include <array>
#include <string>

namespace moltact {
namespace {

// The window draws characters as they come, by 16 bits.
constexpr char32_t kMost = 0xFFFF;

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
    if (FT_New_Face(library, file.c_str(), 0, &face) != 0) continue;
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
  static const std::array<std::filesystem::path, 2> kFonts{kInterRegular, kDejaVu};
  static const GlyphCoverage table(kFonts);
  return table;
}

Writable GlyphCoverage::writable(char32_t c) const {
  if (ranges_.empty() || unseen(c)) return Writable::Yes;
  if (within(kNeedLayout, c)) return Writable::NeedsLayout;
  return c <= kMost && within(ranges_, c) ? Writable::Yes : Writable::NoSign;
}

std::string utf8Of(char32_t c) {
  std::string out;
  const auto add = [&](char32_t byte) { out += static_cast<char>(static_cast<unsigned char>(byte)); };
  if (c < 0x80) {
    add(c);
  } else if (c < 0x800) {
    add(0xC0 | c >> 6), add(0x80 | (c & 0x3F));
  } else if (c < 0x10000) {
    add(0xE0 | c >> 12), add(0x80 | (c >> 6 & 0x3F)), add(0x80 | (c & 0x3F));
  } else {
    add(0xF0 | c >> 18), add(0x80 | (c >> 12 & 0x3F)), add(0x80 | (c >> 6 & 0x3F)), add(0x80 | (c & 0x3F));
  }
  return out;
}

std::vector<char32_t> charactersOf(std::string_view utf8) {
  std::vector<char32_t> out;
  for (std::size_t k = 0; k < utf8.size();) {
    const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(utf8[at]); };
    const unsigned char b = byte(k);
    const std::size_t length = b < 0x80                ? 1
                               : b >= 0xC2 && b < 0xE0 ? 2
                               : b >= 0xE0 && b < 0xF0 ? 3
                               : b >= 0xF0 && b < 0xF5 ? 4
                                                       : 0;
    if (length == 0 || k + length > utf8.size()) {
      ++k;
      continue;
    }
    char32_t c = length == 1 ? b : b & (0xFFu >> (length + 1));
    bool sound = true;
    for (std::size_t j = 1; j < length; ++j) {
      sound = sound && (byte(k + j) & 0xC0) == 0x80;
      c = c << 6 | (byte(k + j) & 0x3Fu);
    }
    if (sound) out.push_back(c);
    k += sound ? length : 1;
  }
  return out;
}

}  // namespace moltact
