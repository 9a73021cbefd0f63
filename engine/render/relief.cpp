#include "engine/render/relief.h"

#include <algorithm>

#include "engine/render/height_picture.h"

namespace moltact {
namespace {

constexpr double kLift_A = 0.02;  // so that the atoms do not pierce it where they stop the tip

}  // namespace

MeshPiece reliefOf(const HeightField& field, int lines) {
  MeshPiece out;
  out.origin_A = field.frame.toMolecule({0.5 * field.width_A(), 0.5 * field.depth_A(), 0.0});
  if (lines < 2) return out;
  const double per_A = 1.0 / highest_A(field, lines);
  const auto height = [&](int column, int row) {
    return field.at(std::clamp(column, 0, field.columns - 1), std::clamp(row, 0, lines - 1));
  };
  for (int row = 0; row < lines; ++row)
    for (int column = 0; column < field.columns; ++column) {
      const Vec3 place(field.spacing_A * column, field.spacing_A * row, height(column, row) + kLift_A);
      const Vec3 normal(height(column - 1, row) - height(column + 1, row),
                        height(column, row - 1) - height(column, row + 1), 2.0 * field.spacing_A);
      out.vertices.push_back({glm::vec3(field.frame.toMolecule(place) - out.origin_A),
                              glm::vec3(field.frame.orientation * glm::normalize(normal)),
                              packColour(heightColour(per_A * place.z), 1.0f)});
    }
  const auto columns = static_cast<std::uint32_t>(field.columns);
  for (std::uint32_t row = 0; row + 1 < static_cast<std::uint32_t>(lines); ++row)
    for (std::uint32_t column = 0; column + 1 < columns; ++column) {
      const std::uint32_t a = row * columns + column, b = a + 1, c = b + columns, d = a + columns;
      out.triangle(a, b, c);
      out.triangle(a, c, d);
    }
  return out;
}

void addScanningTip(const ViewScene& scene, std::vector<LooseSphere>& shell) {
  if (!scene.scanning_tip) return;
  constexpr float kAlpha = 0.9f;
  const DrawnTip& tip = *scene.scanning_tip;
  shell.push_back(
      {glm::vec3(scene.camera.toView(tip.centre)), float(tip.radius_A), packColour(scene.theme.probe, kAlpha)});
}

}  // namespace moltact
