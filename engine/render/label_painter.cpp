#include "engine/render/label_painter.h"

#include <algorithm>

#include "engine/core/utf8.h"
#include "engine/fonts/text_face.h"
#include "engine/render/picture_painter.h"

namespace moltact {
namespace {

constexpr double kLine_px = 17.0, kCorner_px = 6.0, kGround = 0.86;

}  // namespace

LabelColours labelColours(const Theme& theme) {
  const bool light = glm::dot(theme.background_top, Colour(1.0f)) > 1.5f;
  return light ? LabelColours{Colour(1.0f), Colour(0.07f, 0.10f, 0.14f), Colour(0.10f, 0.13f, 0.18f)}
               : LabelColours{Colour(0.09f, 0.11f, 0.15f), Colour(0.93f, 0.95f, 0.98f), Colour(0.93f, 0.95f, 0.98f)};
}

bool paintLabels(Picture& picture, const ViewScene& scene, const SphereGrid* spheres, double unit_px) {
  const TextFace face(kLine_px * unit_px);
  if (!face.good()) return false;
  const LabelRoom room{picture.width_px, picture.height_px, unit_px, [&](const std::string& text) {
                         const auto [width, height] = face.size(charactersOf(text));
                         return glm::dvec2(width, height);
                       }};
  const LabelColours colours = labelColours(scene.theme);
  PicturePainter paint(picture);
  for (const PlacedLabel& l : layOutLabels(scene, spheres, room)) {
    if (const ArrowShape arrow = arrowOf(l, unit_px); arrow.drawn) {
      paint.line(arrow.from, arrow.neck, 4.4 * unit_px, colours.ground, 0.6 * l.strength);
      paint.line(arrow.from, arrow.neck, 2.0 * unit_px, colours.line, l.strength);
      paint.triangle(l.tip, arrow.left, arrow.right, colours.line, l.strength);
    }
    paint.box(l.low, l.high, kCorner_px * unit_px, colours.ground, kGround * l.strength);
    const glm::dvec2 at = l.low + labelPadding_px(unit_px);
    face.draw(charactersOf(l.text), at.x, at.y,
              [&](int x, int y, float coverage) { paint.blend(x, y, colours.text, double(coverage) * l.strength); });
  }
  return true;
}

}  // namespace moltact
