// The points in which three spheres meet, and the planes that bound a point's volume (paper, section 4.5, Figure 7,
// equations 5 to 7). Plain functions without state, usable on every thread; they neither allocate nor throw. Units:
// angstrom.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "engine/haptics/paper/intersection_circle.h"

namespace moltact::paper {

struct IntersectionPoints {
  Vec3 P0{0.0}, P1{0.0};
};

/// Equations 5 and 6: the points where the circle of two spheres meets a third sphere of centre S2 and radius r. Empty
/// where it does not meet it, only touches it, or lies on it all round.
std::optional<IntersectionPoints> intersectionPoints(const IntersectionCircle& circle, const Vec3& S2, double r);

/// One plane of a point (equation 7), through the point and the axis of one of its circles.
struct PointPlane {
  Vec3 normal{0.0};                            ///< unit vector N, oriented to the side of the volume
  std::array<std::int32_t, 2> circle{-1, -1};  ///< the circle to go to past this plane, by its two atoms
};

/// An intersection point with its volume: the places on the inner side of all three planes (case 3).
struct PointVolume {
  Vec3 P{0.0};
  std::array<PointPlane, 3> planes;

  /// The plane that the HIP is farthest past, or nullptr while it is in the volume.
  const PointPlane* crossed(const Vec3& hip) const;
};

/// The volume of P, where the spheres of `atoms` with these centres meet. Empty where P and the centres lie in one
/// plane: then there is no volume.
std::optional<PointVolume> pointVolume(const Vec3& P, const std::array<std::int32_t, 3>& atoms,
                                       const std::array<Vec3, 3>& centres);

}  // namespace moltact::paper
