#include "engine/fonts/text_face.h"

#include <ft2build.h>
#include FT_FREETYPE_H

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/fonts/font_files.h"

namespace moltact {
struct TextFace::Fonts {
  FT_Library library = nullptr;
  std::vector<FT_Face> faces;  // the first face that contains a character draws it
  double ascent = 0.0, height = 0.0;

  // Loads and renders a glyph; null if no face contains it.
  FT_GlyphSlot load(char32_t code) const {
    for (const FT_Face face : faces)
      if (const FT_UInt glyph = FT_Get_Char_Index(face, code); glyph != 0)
        return FT_Load_Glyph(face, glyph, FT_LOAD_RENDER | FT_LOAD_TARGET_LIGHT) == 0 ? face->glyph : nullptr;
    return nullptr;
  }
};

TextFace::TextFace(double line_px) : fonts_(std::make_unique<Fonts>()) {
  if (FT_Init_FreeType(&fonts_->library) != 0) {
    fonts_->library = nullptr;
    return;
  }
  for (const std::filesystem::path& file : {interFile("Inter-Regular.otf"), dejaVuFile()}) {
    FT_Face face = nullptr;
    if (FT_New_Face(fonts_->library, file.string().c_str(), 0, &face) != 0) continue;
    if (FT_Select_Charmap(face, FT_ENCODING_UNICODE) != 0 ||
        FT_Set_Pixel_Sizes(face, 0, FT_UInt(std::max(1.0, std::round(line_px / 1.21)))) != 0) {
      FT_Done_Face(face);
      continue;
    }
    if (fonts_->faces.empty()) {
      fonts_->ascent = double(face->size->metrics.ascender) / 64.0;
      fonts_->height = double(face->size->metrics.ascender - face->size->metrics.descender) / 64.0;
    }
    fonts_->faces.push_back(face);
  }
}

TextFace::~TextFace() {
  for (const FT_Face face : fonts_->faces) FT_Done_Face(face);
  if (fonts_->library) FT_Done_FreeType(fonts_->library);
}

bool TextFace::good() const { return !fonts_->faces.empty(); }

std::pair<double, double> TextFace::size(std::span<const char32_t> line) const {
  double width = 0.0;
  for (const char32_t code : line)
    if (const FT_GlyphSlot glyph = fonts_->load(code)) width += double(glyph->advance.x) / 64.0;
  return {width, fonts_->height};
}

void TextFace::draw(std::span<const char32_t> line, double x_px, double y_px,
                    const std::function<void(int x, int y, float coverage)>& pixel) const {
  double x = x_px;
  const int base = int(std::lround(y_px + fonts_->ascent));
  for (const char32_t code : line) {
    const FT_GlyphSlot glyph = fonts_->load(code);
    if (!glyph) continue;
    const FT_Bitmap& map = glyph->bitmap;
    if (map.pixel_mode == FT_PIXEL_MODE_GRAY)
      for (unsigned row = 0; row < map.rows; ++row)
        for (unsigned column = 0; column < map.width; ++column)
          if (const unsigned char c = map.buffer[std::size_t(row) * std::size_t(map.pitch) + column]; c != 0)
            pixel(int(std::lround(x)) + glyph->bitmap_left + int(column), base - glyph->bitmap_top + int(row),
                  float(c) / 255.0f);
    x += double(glyph->advance.x) / 64.0;
  }
}

}  // namespace moltact
