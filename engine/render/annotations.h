// Annotations in a picture: names, arrows, lengths and angles, hydrogen bonds, trails. Immutable after construction, so
// pictures compare them by address. Plain data. Units: angstrom.
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
    double clear_A = 0.0;  ///< radius of the named object around `at`; spheres within it do not hide the label
    std::string text;
    bool arrow = false;   ///< draw an arrow from the name to the point
    bool always = false;  ///< if atoms hide the point, the label is drawn faintly instead of omitted
  };
  enum class Line : std::uint8_t { Measure, Bond, Clash };  ///< its colour
  struct Measure {
    std::vector<PointA> places;  ///< two, three or four
    std::string text;
    Line line = Line::Measure;
    friend bool operator==(const Measure&, const Measure&) = default;
  };
  std::vector<Label> labels;
  std::vector<Measure> measures;
  std::vector<std::pair<PointA, PointA>> bonds;  ///< hydrogen bonds
  std::vector<std::vector<PointA>> trail;        ///< the path of a probe, in segments
};

/// The dashes of a line between two points.
std::vector<std::pair<PointA, PointA>> dashesBetween(PointA a, PointA b);

/// Appends the lines in the camera's axes: measures with the arc of their angle, dashed bonds, the trail.
void addLines(const Annotations& annotations, const Camera& camera, const Theme& theme, Strokes& strokes);

}  // namespace moltact
