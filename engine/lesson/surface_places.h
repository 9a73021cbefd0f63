// Where a probe rests on a molecule: on the face of one atom, in the crease between two, in the pit between three; and
// the way by which it comes there from outside. For tasks that follow a crease and for hands that show how a task is
// done. Not for the haptic thread. Units: angstrom.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/haptics/sphere_grid.h"
#include "engine/haptics/tracker.h"

namespace moltact {

struct SurfacePlace {
  Vec3 scp_A{0.0};        ///< where the contact point rests
  Vec3 outward{0, 0, 1};  ///< unit: away from the atoms that hold it
  std::array<std::int32_t, 3> atoms{-1, -1, -1};
  Feature feature = Feature::Sphere;
};

/// Even places on the grown spheres of these atoms that no other atom covers: `directions` of each, less the covered
/// ones.
std::vector<SurfacePlace> facePlaces(const SphereGrid& scene, std::span<const std::uint32_t> atoms, double probe_A,
                                     int directions);

/// Places at most `spacing_A` apart along every crease between two of these atoms, less those that another atom covers.
/// A crease has kMaxCreasePlaces at most, which are farther apart on one that is longer than so many spacings.
inline constexpr int kMaxCreasePlaces = 20'000;
std::vector<SurfacePlace> creasePlaces(const SphereGrid& scene, std::span<const std::uint32_t> atoms, double probe_A,
                                       double spacing_A);

/// Every pit between three of these atoms that no other atom covers.
std::vector<SurfacePlace> pitPlaces(const SphereGrid& scene, std::span<const std::uint32_t> atoms, double probe_A);

/// Whether a probe comes to the place from far outside straight along `outward` without meeting an atom.
bool openFromOutside(const SphereGrid& scene, const SurfacePlace& place, double probe_A);

}  // namespace moltact
