// What menus and switches call the parts of the picture.
#pragma once

#include <string>

#include "engine/language/catalogue.h"
#include "engine/render/view_scene.h"

namespace moltact {

/// "Hand (HIP)", "Creases (circles)": for the screen, the lessons' word first.
inline std::string shapeLabel(const ShapeName& shape) {
  if (shape.shape == Shape::Hip) return tr("Hand (HIP)");
  if (shape.shape == Shape::Scp) return tr("Contact point (SCP)");
  if (shape.shape == Shape::Spheres) return tr("Faces (grown spheres)");
  if (shape.shape == Shape::Circles) return tr("Creases (circles)");
  if (shape.shape == Shape::Points) return tr("Pits (points)");
  if (shape.shape == Shape::Atoms) return tr("Atoms");
  if (shape.shape == Shape::Cones) return tr("Cones");
  if (shape.shape == Shape::Force) return trc("the arrow", "Force");
  if (shape.shape == Shape::Probe) return tr("Probe");
  if (shape.shape == Shape::Target) return tr("Target");
  if (shape.shape == Shape::Facets) return tr("Facets");
  return std::string(shape.name);
}

}  // namespace moltact
