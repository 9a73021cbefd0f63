// The points common to three spheres, and the planes that bound a point's volume (paper, section 4.5, Figure 7,
// equations 5 to 7). Pure functions, usable on every thread; they neither allocate nor throw. Units: angstrom.
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
/// if they do not meet, touch in one point, or the whole circle lies on the sphere.
std::optional<IntersectionPoints> intersectionPoints(const IntersectionCircle& circle, const Vec3& S2, double r);

/// One bounding plane of a point's volume (equation 7), through the point and the axis of one of its circles.
struct PointPlane {
  Vec3 normal{0.0};                            ///< unit vector N, toward the volume
  std::array<std::int32_t, 2> circle{-1, -1};  ///< the two atoms of the circle that takes over beyond this plane
};

/// An intersection point with its volume: the region on the inner side of all three planes (case 3).
struct PointVolume {
  Vec3 P{0.0};
  std::array<PointPlane, 3> planes;

  /// The plane that the HIP has crossed farthest, or nullptr while it is in the volume.
  const PointPlane* crossed(const Vec3& hip) const;
};

/// The volume of point P, common to the spheres of `atoms` with these centres. Empty if P and the centres are coplanar.
std::optional<PointVolume> pointVolume(const Vec3& P, const std::array<std::int32_t, 3>& atoms,
                                       const std::array<Vec3, 3>& centres);

}  // namespace moltact::paper
