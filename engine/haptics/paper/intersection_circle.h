// The circle in which two spheres meet (paper, section 4.4, Figure 5, equations 2 to 4).
// Pure functions, usable on every thread; they neither allocate nor throw. Units: angstrom.
#pragma once

#include <optional>

#include "engine/core/units.h"

namespace moltact::paper {

/// Equation 2: the distance from the centre of a sphere of radius R to the plane of the circle that it shares with a
/// sphere of radius r. The distance is along the line of the centres, which are d > 0 apart. Negative if the plane lies
/// on the other side of the first centre.
double circleHeight(double R, double r, double d);

struct IntersectionCircle {
  Vec3 centre{0.0};          ///< C1
  Vec3 axis{1.0, 0.0, 0.0};  ///< unit vector from the first sphere's centre to the second's (the paper's S^, later n)
  double radius = 0.0;       ///< a, above 0
  double height = 0.0;       ///< x, from the first centre to the circle's plane along the axis
};

/// Equations 2 to 4 for spheres (S0, R) and (S1, r). Empty if there is no circle: the spheres are apart, touch in one
/// point or are concentric, or one contains the other.
std::optional<IntersectionCircle> intersectionCircle(const Vec3& S0, double R, const Vec3& S1, double r);

/// The point of the circle nearest to `hip`. For a HIP on the circle's axis, where all points are equally near, the
/// point nearest to `last`; if that is on the axis too, any point.
Vec3 closestOnCircle(const IntersectionCircle& circle, const Vec3& hip, const Vec3& last);

}  // namespace moltact::paper
