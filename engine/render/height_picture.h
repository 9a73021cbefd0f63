// A scan as a picture of colours, from dark (low) to bright (high), for the window and for files. Pure except for
// reading the fonts' files; any thread. Units: angstrom, pixel.
#pragma once

#include "engine/haptics/height_field/height_field.h"
#include "engine/render/atom_style.h"
#include "engine/render/picture.h"

namespace moltact {

/// The colour of a height that is this share (0 to 1) of the highest. The brightness rises evenly.
Colour heightColour(double share);

/// The greatest height of the first `lines` lines, at least 1e-6.
double highest_A(const HeightField& field, int lines);

/// One pixel per node; the greatest y is at the top. Lines from `lines` on have the colour `ground`.
Picture heightPicture(const HeightField& field, int lines, const Colour& ground);

/// The finished scan for people, at least `least_px` wide and high. Each node is a square, a bar of lengths lies in the
/// corner, and beside the picture are the colours with the lowest and the greatest height. Returns an empty picture if
/// no font is installed.
Picture paintedScan(const HeightField& field, int least_px = 640);

}  // namespace moltact
