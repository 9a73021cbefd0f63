// Which of the balls that the SCP touches hold it back: the active set of the projection of the pull on the cone of
// allowed motions. Haptic thread; no allocation. Units: angstrom.
//
// The steepest way down |x - h|^2 that leaves no touching ball is the projection v of d = h - s on {v : v.n_k >= 0}, n_k
// the outward normals; by Caratheodory's theorem at most three normals are active in space. docs/exact-tracker.md derives
// the bound on rounding that `blocked` uses.
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
  Vec3 normal;       ///< unit but for rounding, outward
  double radius;     ///< of curvature; infinite for a plane (unit: angstrom)
  double gap;        ///< from the surface to the place: negative where it has sunk (unit: angstrom)
  std::int32_t ball; ///< or whatever else the surface belongs to
};

/// How much of a motion of length `motion_A` may lead into a touching surface without blocking it (unit: angstrom), in two
/// parts. Rounding of the pull and of the normal: 1/128 of what counts as touching, and 16 times that for a place that has not
/// yet sunk. And grazing: a way that meets a sphere under the angle sqrt(2 contact / radius) sinks by no more than contact_A
/// before it leads out again.
inline double blockedFrom_A(const Touch& touch, double contact_A, double pull_A, double motion_A, bool grazes) {
  const double unsunk = std::clamp(1.0 + touch.gap / contact_A, 0.0, 2.0);
  const double grazing = grazes ? motion_A * std::sqrt(2.0 * unsunk * contact_A / touch.radius) : 0.0;
  return contact_A * (0.125 * std::min(unsunk, 1.0) + 0x1p-7) * (1.0 + pull_A / touch.radius) + grazing;
}

/// What is left of the pull moves nothing where it is no longer than this (unit: angstrom).
inline double stillUnder_A(double contact_A, double pull_A) { return 4.0 * contact_A * (1.0 + pull_A); }

struct ActiveSet {
  int count = 0;                       ///< 0 to 3; with three, nothing is left of the pull and the place holds
  std::array<int, 3> by{-1, -1, -1};   ///< places in the list of touches
  bool still = false;                  ///< nothing but rounding is left of the pull
  bool found = true;                   ///< false: there are no more than Admitted::skip sets
};

struct Admitted {
  int skip = 0;        ///< where rounding admits several sets (a holder about to let go, two spheres with one tangent plane), so many are passed over
  bool grazes = true;  ///< whether a way may graze a touching sphere
};

/// The set with the fewest holders that blocks all that must be blocked.
ActiveSet activeSet(const Vec3& pull, std::span<const Touch> touches, double contact_A, Admitted admitted = {}) noexcept;

}  // namespace moltact
