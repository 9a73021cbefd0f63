// Which of the spheres that the SCP touches hold it back: the active set of the projection of the displacement on the
// cone of allowed motions. Haptic thread; no allocation. Units: angstrom.
//
// The direction steepest down |x - h|^2 that enters no touching sphere is the projection v of d = h - s on {v : v.n_k >=
// 0}, n_k the outward normals; by Caratheodory's theorem at most three normals are active in space.
// docs/exact-tracker.md derives these bounds on rounding.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "engine/core/units.h"

namespace moltact {

/// A surface that a place touches.
struct Touch {
  Vec3 normal;          ///< unit but for rounding, outward
  double radius;        ///< of curvature; infinite for a plane (unit: angstrom)
  double gap;           ///< from the surface to the place: negative where it has sunk (unit: angstrom)
  std::int32_t sphere;  ///< or whatever else the surface belongs to
};

/// What is left of rounding's share for a place that has sunk: all of it to contact_A, nothing from three times that.
inline double roundingShare(const Touch& touch, double contact_A) {
  return std::clamp(0.5 * (3.0 + touch.gap / contact_A), 1e-6, 1.0);
}

/// How much of a motion may lead into a touching surface by rounding of the displacement and of the normal (unit:
/// angstrom): 1/128 of what counts as touching, and where the place `may_sink`, 16 times that as long as it has not.
inline double rounding_A(const Touch& touch, double contact_A, double displacement_A, bool may_sink = true) {
  const double share = (may_sink ? 0.125 * std::clamp(1.0 + touch.gap / contact_A, 0.0, 1.0) : 0.0) +
                       0x1p-7 * roundingShare(touch, contact_A);
  return contact_A * share * (1.0 + displacement_A / touch.radius);
}

/// The same where no path may graze, for a motion along spheres that is computed from the centre of one, `far_A` from
/// the HIP: a place that is off by 1/128 of what counts as touching rotates it by as much times far_A * bend, bend
/// being the larger curvature of its holders, and the normal that it is compared with by as much over its radius.
/// `loose`: what the motion's own direction is off by.
inline double nearCentre_A(const Touch& touch, double contact_A, double far_A, double bend, double loose) {
  return far_A * roundingShare(touch, contact_A) * (0x1p-7 * contact_A * (bend + 1.0 / touch.radius) + loose);
}

/// The sine under which a path may meet a touching sphere and not be blocked, for it sinks by no more than the place
/// may. The gap along the path is gap - sine t + bend t^2 / 2: with bend > 0 it is least at sine / bend; otherwise it
/// is looked at where a tangent has left the sphere by contact_A. `bend` (unit: 1 / angstrom): how fast path and sphere
/// part.
inline double grazing(const Touch& touch, double contact_A, double bend) {
  const double left_A = contact_A + touch.gap;  // how far it may sink yet
  if (bend > 0.0) return std::sqrt(2.0 * bend * std::max(left_A, contact_A / 16.0));
  const double distance_A = std::sqrt(contact_A * touch.radius);
  return std::max(0.0, left_A / distance_A + 0.5 * bend * distance_A);
}

/// What is left of the displacement moves nothing where it is no longer than this (unit: angstrom): a place that
/// touches is known to within 4 contact_A, from 3 sunk to 1 above, which shifts the displacement by as much and
/// rotates the normal by as much over the radius.
inline double stillUnder_A(const Touch& touch, double contact_A, double displacement_A) {
  return 4.0 * contact_A * (1.0 + displacement_A / touch.radius);
}

struct ActiveSet {
  int count = 0;                      ///< 0 to 3; with three, nothing is left of the displacement and the place holds
  std::array<int, 3> by{-1, -1, -1};  ///< places in the list of touches
  bool still = false;                 ///< nothing but rounding is left of the displacement
  bool found = true;                  ///< false: there are no more than Admitted::skip sets
};

struct Admitted {
  int skip = 0;  ///< where rounding admits several sets (a holder about to let go, two spheres with one tangent plane),
                 ///< so many are passed over
  bool grazes =
      true;  ///< whether a path may graze a touching sphere, and sink into it by rounding; never so with planes
};

/// The set with the fewest holders that blocks all that must be blocked.
ActiveSet activeSet(const Vec3& displacement, std::span<const Touch> touches, double contact_A,
                    Admitted admitted = {}) noexcept;

}  // namespace moltact
