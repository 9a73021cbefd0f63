// A cone of the paper (section 4.4, Figure 6). Its apex is a sphere's centre and its base an intersection circle. While
// the HIP is inside a cone, the SCP is the closest point of the circle (case 2). Each circle is the base of two cones.
// Pure functions, usable on every thread; they neither allocate nor throw. Units: angstrom.
#pragma once

#include <cstdint>

#include "engine/haptics/paper/intersection_circle.h"

namespace moltact::paper {

struct Cone {
  IntersectionCircle circle;    ///< its axis points from the apex toward the neighbour's centre
  Vec3 apex{0.0};               ///< the centre of `atom`
  std::int32_t atom = -1;       ///< the atom that owns the cone (in the paper: parent)
  std::int32_t neighbour = -1;  ///< the other sphere of the circle; its cone shares the base
};

/// The test of Figure 6 according to the text. The HIP, projected onto the circle's plane, lies less than the circle's
/// radius from C1. The angle at the apex between HIP and axis is at most that of the cone.
bool insideCone(const Cone& cone, const Vec3& hip);

/// True if the HIP lies beyond the circle's plane, on the neighbour's side.
bool pastBase(const Cone& cone, const Vec3& hip);

/// The cone on the same circle whose apex is the neighbour's centre.
Cone neighbourCone(const Cone& cone, const Vec3& neighbour_centre);

}  // namespace moltact::paper
