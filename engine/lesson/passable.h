// How large a probe may be that still comes to a place on a molecule from outside, or through a ring of atoms. For tasks
// that ask for it and for their check; not for the haptic thread. Units: angstrom.
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

/// The places where a probe rests on one of these atoms, alone or with its neighbours, and to which it comes from far
/// outside in a straight line; where `wanted` is given, of those for which it says true. With `first_only` at most one.
std::vector<SurfacePlace> comesTo(const SphereGrid& scene, std::span<const std::uint32_t> atoms, double probe_A,
                                  bool first_only = false, const std::function<bool(const SurfacePlace&)>& wanted = {});

/// A ring of atoms, as far as a probe that goes through it sees it.
struct AtomRing {
  Vec3 centre_A{0.0}, axis{0, 0, 1};  ///< the axis is across the plane that lies nearest to the atoms
  double radius_A = 0.0;              ///< from the centre to the farthest of the atoms' centres
};
/// Nothing for fewer than three atoms.
std::optional<AtomRing> ringOf(const SphereGrid& scene, std::span<const std::uint32_t> atoms);

/// A line along the ring's axis on which a probe goes through it without meeting an atom, by the place where it crosses
/// the ring's plane; the widest that was found. Nothing where none is free.
std::optional<Vec3> wayThrough(const SphereGrid& scene, const AtomRing& ring, double probe_A);

/// The largest probe for which `fits` says true, from `least_A` to `most_A`, to 0.01: where it says true of the
/// largest, that. Nothing where it says true of none. A smaller probe must fit wherever a larger one does.
template <class Fits>
std::optional<double> largestProbe(double least_A, double most_A, Fits&& fits) {
  if (!fits(least_A)) return std::nullopt;
  if (fits(most_A)) return most_A;
  while (most_A - least_A > 0.01) {
    const double middle_A = 0.5 * (least_A + most_A);
    (fits(middle_A) ? least_A : most_A) = middle_A;
  }
  return least_A;
}

}  // namespace moltact
