// Where the names, arrows and measures of a picture stand: one calculation for the window and for pictures in files.
// Names do not overlap; the nearest and the author's own come first, and what finds no room is left out. Pure functions.
// Units: pixel from the upper left corner, angstrom.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/haptics/sphere_grid.h"
#include "engine/render/view_scene.h"

namespace moltact {

struct PlacedLabel {
  std::string text;
  glm::dvec2 low{0.0}, high{0.0};  ///< the box of its ground
  glm::dvec2 tip{0.0};             ///< the place that it names
  bool arrow = false;              ///< from the box to the tip
  bool measure = false;
  double strength = 1.0;  ///< below 1 where atoms hide the place
};

struct LabelRoom {
  int width_px = 0, height_px = 0;
  double unit_px = 1.0;                                    ///< a pixel of 96 dpi
  std::function<glm::dvec2(const std::string&)> textSize;  ///< of a line of text
};

/// How far the text stands from the edge of its box.
glm::dvec2 labelPadding_px(double unit_px);

/// All labels and measures of the scene. `spheres` are its atoms, which hide places where they are drawn as solid as they
/// are; null: nothing hides.
std::vector<PlacedLabel> layOutLabels(const ViewScene& scene, const SphereGrid* spheres, const LabelRoom& room);

/// The head and the shaft of an arrow from a label's box to its tip: the shaft's beginning, where the head begins, its two
/// corners; the tip is the label's. Nothing where the tip lies in the box.
struct ArrowShape {
  bool drawn = false;
  glm::dvec2 from{0.0}, neck{0.0}, left{0.0}, right{0.0};
};
ArrowShape arrowOf(const PlacedLabel& label, double unit_px);

}  // namespace moltact
