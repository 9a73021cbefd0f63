// Finds the active set: the touched spheres that block the motion of the SCP toward the HIP. Haptic thread; no
// allocation. Units: angstrom.
//
// The displacement is d = h - s, from the SCP s to the HIP h. The direction of steepest descent of |x - h|^2 that
// enters no touched sphere is the projection v of d on the cone {v : v.n_k >= 0}. The n_k are the outward normals. By
// Caratheodory's theorem at most three normals are active in space. docs/exact-tracker.md derives the bounds on
// rounding used here.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "engine/core/units.h"

namespace moltact {

/// A surface that the SCP touches.
struct Touch {
  Vec3 normal;    ///< outward; of unit length within rounding
  double radius;  ///< radius of curvature; infinite for a plane (unit: angstrom)
  double gap;     ///< signed distance from the surface to the SCP; negative: the SCP has penetrated (unit: angstrom)
  std::int32_t sphere;  ///< index of the sphere, or the caller's identifier of another surface
};

/// Factor, 1e-6 to 1, that reduces the tolerance for rounding of a penetrating SCP. It is 1 down to a depth of
/// contact_A and falls linearly to zero at three times that depth.
inline double roundingShare(const Touch& touch, double contact_A) {
  return std::clamp(0.5 * (3.0 + touch.gap / contact_A), 1e-6, 1.0);
}

/// The part of a motion into a touched surface that counts as rounding of displacement and normal (unit: angstrom). It
/// is 1/128 of contact_A. With `may_sink`, an SCP that has not penetrated is allowed 16 times as much in addition.
inline double rounding_A(const Touch& touch, double contact_A, double displacement_A, bool may_sink = true) {
  const double share = (may_sink ? 0.125 * std::clamp(1.0 + touch.gap / contact_A, 0.0, 1.0) : 0.0) +
                       0x1p-7 * roundingShare(touch, contact_A);
  return contact_A * share * (1.0 + displacement_A / touch.radius);
}

/// The same tolerance where no path may graze, for a motion along spheres that is computed from the centre of one of
/// them. The centre is `far_A` from the HIP. An SCP that is off by contact_A / 128 rotates the motion by that length
/// times far_A * bend; `bend` is the larger curvature of the active spheres. It rotates the compared normal by that
/// length over its radius. `loose`: error of the motion's own direction (unit: radian).
inline double nearCentre_A(const Touch& touch, double contact_A, double far_A, double bend, double loose) {
  return far_A * roundingShare(touch, contact_A) * (0x1p-7 * contact_A * (bend + 1.0 / touch.radius) + loose);
}

/// The largest sine of the angle at which a path may enter a touched sphere without being blocked: the path then
/// penetrates no deeper than the SCP may. The gap along the path is gap - sine t + bend t^2 / 2. With bend > 0 its
/// minimum is at sine / bend. Otherwise the gap is evaluated where a tangent has left the sphere by contact_A. `bend`
/// is the rate at which path and sphere separate (unit: 1 / angstrom).
inline double grazing(const Touch& touch, double contact_A, double bend) {
  const double left_A = contact_A + touch.gap;  // depth by which the SCP may still penetrate
  if (bend > 0.0) return std::sqrt(2.0 * bend * std::max(left_A, contact_A / 16.0));
  const double distance_A = std::sqrt(contact_A * touch.radius);
  return std::max(0.0, left_A / distance_A + 0.5 * bend * distance_A);
}

/// A remaining displacement of at most this length moves nothing (unit: angstrom). The position of a touching SCP is
/// known to within 4 contact_A, from 3 below the surface to 1 above. This uncertainty shifts the displacement by the
/// same length and rotates the normal by that length over the radius.
inline double stillUnder_A(const Touch& touch, double contact_A, double displacement_A) {
  return 4.0 * contact_A * (1.0 + displacement_A / touch.radius);
}

/// The result of activeSet().
struct ActiveSet {
  int count = 0;                      ///< 0 to 3; three surfaces leave no motion
  std::array<int, 3> by{-1, -1, -1};  ///< indices into the list of touches
  bool still = false;                 ///< only rounding is left of the displacement
  bool found = true;                  ///< false: at most Admitted::skip sets exist
};

/// Which sets activeSet() accepts.
struct Admitted {
  int skip = 0;  ///< number of acceptable sets to skip; rounding admits several where a contact is about to open or two
                 ///< spheres share a tangent plane
  bool grazes = true;  ///< a path may graze a touched sphere and penetrate it by rounding; must be false for planes
};

/// Returns the smallest active set that blocks every motion into a touched surface. `displacement` points from the SCP
/// to the HIP.
ActiveSet activeSet(const Vec3& displacement, std::span<const Touch> touches, double contact_A,
                    Admitted admitted = {}) noexcept;

}  // namespace moltact
