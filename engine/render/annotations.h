// What is written into a picture: names, arrows, lengths and angles, hydrogen bonds. Made once for a scene and never
// changed, so that pictures are compared by its address. Plain data. Units: angstrom.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "engine/core/units.h"
#include "engine/render/wireframe.h"

namespace moltact {

struct Camera;
struct Theme;

struct Annotations {
  struct Label {
    PointA at;
    double clear_A = 0.0;  ///< what belongs to the name reaches so far from `at`: it does not hide it
    std::string text;
    bool arrow = false;   ///< an arrow leads from the name to the place
    bool always = false;  ///< an author's own: faint, and not left out, where atoms hide the place
  };
  struct Measure {
    std::vector<PointA> places;  ///< two, three or four
    std::string text;
  };
  std::vector<Label> labels;
  std::vector<Measure> measures;
  std::vector<std::pair<PointA, PointA>> bonds;  ///< hydrogen bonds
  std::vector<std::vector<PointA>> trail;        ///< the way that a probe took, in pieces
};

/// The dashes of a line between two places.
std::vector<std::pair<PointA, PointA>> dashesBetween(PointA a, PointA b);

/// Adds the lines of it, in the camera's axes: measures with the arc of their angle, dashed bonds, the trail.
void addLines(const Annotations& annotations, const Camera& camera, const Theme& theme, Strokes& strokes);

}  // namespace moltact
