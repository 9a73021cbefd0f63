// A cone of the paper (section 4.4, Figure 6): its apex is a sphere's centre, its base an intersection circle. While
// the HIP is inside one, the SCP is the closest place on the circle (case 2). Each circle is the base of two cones.
// Plain functions without state, usable on every thread; they neither allocate nor throw. Units: angstrom.
#pragma once

#include <cstdint>

#include "engine/haptics/paper/intersection_circle.h"

namespace moltact::paper {

struct Cone {
  IntersectionCircle circle;    ///< its axis points from the apex to the neighbour's centre
  Vec3 apex{0.0};               ///< the centre of `atom`
  std::int32_t atom = -1;       ///< whose cone it is: the paper's parent of the cone
  std::int32_t neighbour = -1;  ///< the other sphere of the circle, whose cone shares the base
};

/// The test of Figure 6 as the text gives it: the HIP, projected onto the circle's plane, lies less than the circle's
/// radius from C1, and the angle at the apex between HIP and axis is at most the cone's.
bool insideCone(const Cone& cone, const Vec3& hip);

/// Whether the HIP has crossed the circle's plane and so is in, or nearer to, the cone of the neighbour.
bool pastBase(const Cone& cone, const Vec3& hip);

/// The cone on the same circle whose apex is the neighbour's centre.
Cone neighbourCone(const Cone& cone, const Vec3& neighbour_centre);

}  // namespace moltact::paper
