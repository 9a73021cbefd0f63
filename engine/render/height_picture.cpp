#include "engine/render/height_picture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/core/utf8.h"
#include "engine/fonts/text_face.h"
#include "engine/language/quantity_text.h"
#include "engine/render/picture_painter.h"

namespace moltact {
namespace {

// Lengths of 1, 2 or 5 times a power of ten.
double roundLength_A(double most_A) {
  const double power = std::pow(10.0, std::floor(std::log10(most_A)));
  for (const double step : {5.0, 2.0})
    if (step * power <= most_A) return step * power;
  return power;
}

}  // namespace

Colour heightColour(double share) {
  constexpr std::array<std::array<float, 3>, 5> kStops{{{0.05f, 0.03f, 0.02f},
                                                        {0.36f, 0.14f, 0.05f},
                                                        {0.71f, 0.36f, 0.09f},
                                                        {0.95f, 0.70f, 0.32f},
                                                        {1.00f, 0.97f, 0.88f}}};
  const double at = std::clamp(share, 0.0, 1.0) * double(kStops.size() - 1);
  const std::size_t k = std::min(static_cast<std::size_t>(at), kStops.size() - 2);
  const auto colour = [&](std::size_t i) { return Colour(kStops[i][0], kStops[i][1], kStops[i][2]); };
  return glm::mix(colour(k), colour(k + 1), float(at - double(k)));
}

double highest_A(const HeightField& field, int lines) {
  double highest = 1e-6;
  const std::size_t end = field.index(0, std::clamp(lines, 0, field.rows));
  for (std::size_t k = 0; k < end; ++k) highest = std::max(highest, field.heights_A[k]);
  return highest;
}

Picture heightPicture(const HeightField& field, int lines, const Colour& ground) {
  Picture out{field.columns, field.rows, {}};
  out.rgb.resize(3 * field.heights_A.size());
  const double per_A = 1.0 / highest_A(field, lines);
  for (int row = 0; row < field.rows; ++row)
    for (int column = 0; column < field.columns; ++column) {
      const Colour c = row < lines ? heightColour(per_A * field.at(column, row)) : ground;
      std::uint8_t* at = out.rgb.data() + 3 * field.index(column, field.rows - 1 - row);
      for (int k = 0; k < 3; ++k) at[k] = std::uint8_t(std::lround(255.0f * c[k]));
    }
  return out;
}

Picture paintedScan(const HeightField& field, int least_px) {
  const int longest = std::max(field.columns, field.rows);
  const int cell = std::max(1, (least_px + longest - 1) / longest);
  const int width = cell * field.columns, height = cell * field.rows;
  const double unit = std::max(1.0, std::max(width, height) / 640.0);
  const TextFace face(16.0 * unit);
  if (!face.good()) return {};
  const double top_A = highest_A(field, field.rows);
  const std::vector<char32_t> high = charactersOf(quantityText(top_A, Dimension::Length, plain(3))),
                              low = charactersOf(quantityText(0.0, Dimension::Length, plain(3)));
  const double bar = 18 * unit, gap = 10 * unit;
  const int beside = int(std::ceil(3 * gap + bar + std::max(face.size(high).first, face.size(low).first)));
  const Colour ground(1.0f), ink(0.1f);
  Picture out{width + beside, std::max(height, int(120 * unit)), {}};
  out.rgb.assign(3 * std::size_t(out.width_px) * std::size_t(out.height_px), 255);
  const Picture small = heightPicture(field, field.rows, ground);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      std::copy_n(small.at(x / cell, y / cell), 3,
                  out.rgb.data() + 3 * (std::size_t(y) * std::size_t(out.width_px) + std::size_t(x)));
  PicturePainter paint(out);
  const auto write = [&](std::span<const char32_t> text, double x, double y, const Colour& colour) {
    face.draw(text, x, y, [&](int px, int py, float coverage) { paint.blend(px, py, colour, double(coverage)); });
  };
  // The colours, from the greatest height down to the substrate.
  const int bar_from = int(width + gap), bar_to = int(bar_from + bar), tall = out.height_px;
  for (int y = 0; y < tall; ++y)
    for (int x = bar_from; x < bar_to; ++x) paint.blend(x, y, heightColour(1.0 - (y + 0.5) / tall), 1.0);
  write(high, bar_to + gap, 0.0, ink);
  write(low, bar_to + gap, tall - face.size(low).second, ink);
  // The bar of lengths.
  const double length_A = roundLength_A(0.3 * field.spacing_A * field.columns),
               length_px = length_A / field.spacing_A * cell;
  const std::vector<char32_t> text = charactersOf(quantityText(length_A, Dimension::Length, plain(3)));
  const auto [text_wide, text_high] = face.size(text);
  const double wide = std::max(length_px, text_wide), x0 = gap + 6 * unit, y1 = height - gap - 8 * unit;
  paint.box({gap, y1 - text_high - 14 * unit}, {gap + wide + 12 * unit, double(height) - gap}, 6 * unit, ground, 0.86);
  paint.line({x0, y1}, {x0 + length_px, y1}, 4 * unit, ink, 1.0);
  write(text, x0, y1 - text_high - 8 * unit, ink);
  return out;
}

}  // namespace moltact
