// The layout of names, arrows and measures in a picture, for the window and for picture files. Names do not overlap.
// Those given by the author are placed first, then the others from near to far; names without room are omitted. Pure
// functions. Units: pixel from the upper left corner, angstrom.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "engine/haptics/sphere_grid.h"
#include "engine/render/view_scene.h"

namespace moltact {

struct PlacedLabel {
  std::string text;
  glm::dvec2 low{0.0}, high{0.0};  ///< corners of the label's box
  glm::dvec2 tip{0.0};             ///< the named point
  bool arrow = false;              ///< draw an arrow from the box to the tip
  bool measure = false;
  double strength = 1.0;  ///< opacity, below 1 where atoms hide the point
};

struct LabelRoom {
  int width_px = 0, height_px = 0;
  double unit_px = 1.0;                                    ///< size of a pixel of 96 dpi
  std::function<glm::dvec2(const std::string&)> textSize;  ///< size of a line of text
};

/// The padding between text and box.
glm::dvec2 labelPadding_px(double unit_px);

/// Lays out all labels and measures of the scene. `spheres` are its atoms, which hide points where they are drawn
/// opaquely; null: nothing hides.
std::vector<PlacedLabel> layOutLabels(const ViewScene& scene, const SphereGrid* spheres, const LabelRoom& room);

/// The shape of an arrow from a label's box to its tip: start of the shaft, start of the head (neck) and the head's two
/// corners. Not drawn if the tip lies in the box.
struct ArrowShape {
  bool drawn = false;
  glm::dvec2 from{0.0}, neck{0.0}, left{0.0}, right{0.0};
};
ArrowShape arrowOf(const PlacedLabel& label, double unit_px);

}  // namespace moltact
