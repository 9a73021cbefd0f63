// Places where a probe rests on a molecule: on the face of one atom, in the crease between two, in the pit between
// three. Also whether the probe reaches them from outside. For tasks that follow a crease and for hands that
// demonstrate a task. Not for the haptic thread. Unit: angstrom.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/haptics/sphere_grid.h"
#include "engine/haptics/tracker.h"

namespace moltact {

struct SurfacePlace {
  Vec3 scp_A{0.0};        ///< the contact point
  Vec3 outward{0, 0, 1};  ///< unit vector away from the atoms that hold the probe
  std::array<std::int32_t, 3> atoms{-1, -1, -1};
  Feature feature = Feature::Sphere;
};

/// Evenly distributed places on the grown spheres of these atoms: `directions` per atom, without places that another
/// atom covers.
std::vector<SurfacePlace> facePlaces(const SphereGrid& scene, std::span<const std::uint32_t> atoms, double probe_A,
                                     int directions);

/// Places at most `spacing_A` apart along every crease between two of these atoms, without places that another atom
/// covers. A crease has at most kMaxCreasePlaces; on a longer one their distance is larger.
inline constexpr int kMaxCreasePlaces = 20'000;
std::vector<SurfacePlace> creasePlaces(const SphereGrid& scene, std::span<const std::uint32_t> atoms, double probe_A,
                                       double spacing_A);

/// Every pit between three of these atoms that no other atom covers.
std::vector<SurfacePlace> pitPlaces(const SphereGrid& scene, std::span<const std::uint32_t> atoms, double probe_A);

/// Whether a probe that comes from far outside, straight against `outward`, reaches the place without touching an atom.
bool openFromOutside(const SphereGrid& scene, const SurfacePlace& place, double probe_A);

}  // namespace moltact
