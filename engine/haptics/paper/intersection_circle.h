// The circle in which two spheres meet (paper, section 4.4, Figure 5, equations 2 to 4).
// Plain functions without state, usable on every thread; neither allocates nor throws. Units: angstrom.
#pragma once

#include <optional>

#include "engine/core/units.h"

namespace moltact::paper {

/// Equation 2: the distance from the centre of the sphere of radius R to the plane of the common circle, along the line
/// to a sphere of radius r whose centre is d > 0 away. Negative where that plane lies behind the first centre.
double circleHeight(double R, double r, double d);

struct IntersectionCircle {
  Vec3 centre{0.0};          ///< C1
  Vec3 axis{1.0, 0.0, 0.0};  ///< unit vector from the first sphere's centre to the second's (the paper's S^, later n)
  double radius = 0.0;       ///< a, above 0
  double height = 0.0;       ///< x, from the first centre to the circle's plane along the axis
};

/// Equations 2 to 4 for spheres (S0, R) and (S1, r). Empty where there is no circle: spheres apart, one inside the
/// other, touching in one point, or concentric.
std::optional<IntersectionCircle> intersectionCircle(const Vec3& S0, double R, const Vec3& S1, double r);

/// The place on the circle nearest to `hip`. For a HIP on the circle's axis all are equally near: then the one nearest
/// to `last`, and where that fails too, any.
Vec3 closestOnCircle(const IntersectionCircle& circle, const Vec3& hip, const Vec3& last);

}  // namespace moltact::paper
