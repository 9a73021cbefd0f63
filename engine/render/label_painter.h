// Names, arrows and measures into a picture in memory, as the window shows them over its own. Pure but for the fonts'
// files; any thread.
#pragma once

#include "engine/render/label_layout.h"
#include "engine/render/picture.h"

namespace moltact {

/// The colours of names on their ground.
struct LabelColours {
  Colour ground, text, line;
};
LabelColours labelColours(const Theme& theme);

/// Writes all labels of the scene, whose picture this is. `unit_px`: a pixel of 96 dpi. False where no font is installed.
bool paintLabels(Picture& picture, const ViewScene& scene, const SphereGrid* spheres, double unit_px);

}  // namespace moltact
