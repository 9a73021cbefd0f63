// Draws names, arrows and measures into a picture in memory, as the window shows them. Pure except for reading the
// fonts' files; any thread.
#pragma once

#include "engine/render/label_layout.h"
#include "engine/render/picture.h"

namespace moltact {

/// The colours of labels.
struct LabelColours {
  Colour ground, text, line;
};
LabelColours labelColours(const Theme& theme);

/// Draws all labels of the scene into its picture. `unit_px`: size of a pixel of 96 dpi. Returns false if no font is
/// installed.
bool paintLabels(Picture& picture, const ViewScene& scene, const SphereGrid* spheres, double unit_px);

}  // namespace moltact
