// Scenes and HIP paths for the benchmarks, generated from a seed and equal in every run. Units: angstrom.
#pragma once

#include <memory>
#include <vector>

#include "engine/haptics/sphere_grid.h"

namespace moltact::bench {

/// A round cluster with the atom density of a protein's heavy atoms (0.06 per cubic angstrom), radii 1.5 to 1.9 A.
std::vector<Sphere> proteinLike(std::size_t count, unsigned seed);

/// `ticks` positions of a HIP that slides over the surface, 0.02 A per tick, about `depth_A` below it.
std::vector<Vec3> slidingPath(const std::shared_ptr<const SphereGrid>& scene, double probe_A, double depth_A,
                              std::size_t ticks, unsigned seed);

/// `ticks` positions of a HIP that wanders around the scene, 0.02 A per tick, 0.5 to 8 A above its surface.
std::vector<Vec3> freePath(const std::shared_ptr<const SphereGrid>& scene, double probe_A, std::size_t ticks,
                           unsigned seed);

}  // namespace moltact::bench
