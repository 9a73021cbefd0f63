// Scenes and HIP paths for the benchmarks: made from a seed, alike in every run. Units: angstrom.
#pragma once

#include <memory>
#include <vector>

#include "engine/haptics/sphere_grid.h"

namespace moltact::bench {

/// A round cluster with the atom density of a protein's heavy atoms (0.06 per cubic angstrom), radii 1.5 to 1.9 A.
std::vector<Sphere> proteinLike(std::size_t count, unsigned seed);

/// `ticks` places of a HIP that slides over the surface, 0.02 A a tick, about `depth_A` under it.
std::vector<Vec3> slidingPath(const std::shared_ptr<const SphereGrid>& scene, double probe_A, double depth_A,
                              std::size_t ticks, unsigned seed);

/// `ticks` places of a HIP that wanders round the scene, 0.02 A a tick, 0.5 to 8 A off its surface.
std::vector<Vec3> freePath(const std::shared_ptr<const SphereGrid>& scene, double probe_A, std::size_t ticks,
                           unsigned seed);

}  // namespace moltact::bench
