// What menus and switches call the parts of the picture.
#pragma once

#include <string>

#include "engine/render/view_scene.h"

namespace moltact {

/// "Hand (HIP)", "Creases (circles)": for the screen, the lessons' word first.
inline std::string shapeLabel(const ShapeName& shape) {
  if (shape.shape == Shape::Hip) return "Hand (HIP)";
  if (shape.shape == Shape::Scp) return "Contact point (SCP)";
  if (shape.shape == Shape::Spheres) return "Faces (grown spheres)";
  if (shape.shape == Shape::Circles) return "Creases (circles)";
  if (shape.shape == Shape::Points) return "Pits (points)";
  std::string label(shape.name);
  if (!label.empty() && label[0] >= 'a' && label[0] <= 'z') label[0] = char(label[0] - 'a' + 'A');
  return label;
}

}  // namespace moltact
