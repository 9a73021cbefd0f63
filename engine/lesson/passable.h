// The largest probe that reaches a place on a molecule from outside, or passes through a ring of atoms. For tasks that
// ask for it and their checks; not for the haptic thread. Unit: angstrom.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "engine/core/units.h"
#include "engine/haptics/sphere_grid.h"
#include "engine/lesson/surface_places.h"

namespace moltact {

/// The places where a probe rests on at least one of these atoms and which it reaches from far outside in a straight
/// line. With `wanted`, only places for which it returns true. With `first_only`, at most one.
std::vector<SurfacePlace> reachablePlaces(const SphereGrid& scene, std::span<const std::uint32_t> atoms, double probe_A,
                                          bool first_only = false,
                                          const std::function<bool(const SurfacePlace&)>& wanted = {});

/// A ring of atoms, as a probe that passes through it needs it.
struct AtomRing {
  Vec3 centre_A{0.0}, axis{0, 0, 1};  ///< normal of the least-squares plane of the atoms
  double radius_A = 0.0;              ///< distance of the farthest atom's centre from `centre_A`
};
/// Nothing for fewer than three atoms.
std::optional<AtomRing> ringOf(const SphereGrid& scene, std::span<const std::uint32_t> atoms);

/// A line parallel to the ring's axis on which the probe passes through without touching an atom, given by its point in
/// the ring's plane. Returns the widest line found; nothing if none is free.
std::optional<Vec3> pathThrough(const SphereGrid& scene, const AtomRing& ring, double probe_A);

/// The largest probe from `min_A` to `max_A` for which `fits` returns true, to 0.01; `max_A` itself if it fits.
/// Nothing if none fits. Wherever a probe fits, smaller ones must fit too.
template <class Fits>
std::optional<double> largestProbe(double min_A, double max_A, Fits&& fits) {
  if (!fits(min_A)) return std::nullopt;
  if (fits(max_A)) return max_A;
  while (max_A - min_A > 0.01) {
    const double middle_A = 0.5 * (min_A + max_A);
    (fits(middle_A) ? min_A : max_A) = middle_A;
  }
  return min_A;
}

}  // namespace moltact
