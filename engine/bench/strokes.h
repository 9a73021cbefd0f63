// The motions for timing and comparing methods: strokes of a HIP over the surface or past it. Units: angstrom.
#pragma once

#include <memory>
#include <vector>

#include "engine/haptics/sphere_grid.h"

namespace moltact::bench {

inline constexpr double kStrokeStep_A = 0.02;  ///< per tick

/// One stroke. The tracker is reset, then moved along `approach` from outside (not counted), then along `counted`.
struct Stroke {
  std::vector<Vec3> approach, counted;
};

struct StrokePlan {
  std::size_t strokes = 40;
  std::size_t ticks = 2000;  ///< counted ticks of each stroke
  double depth_A = 0.6;      ///< approximate depth under the surface (contact only)
  std::uint64_t seed = 1;
};

/// Strokes in contact: from a random side to the surface, then sliding 0.02 A per tick. Every counted tick touches.
std::vector<Stroke> contactStrokes(const std::shared_ptr<const SphereGrid>& scene, double probe_A,
                                   const StrokePlan& plan);

/// Strokes in free space near the surface (see freePath), 0.02 A per tick.
std::vector<Stroke> freeStrokes(const std::shared_ptr<const SphereGrid>& scene, double probe_A, const StrokePlan& plan);

}  // namespace moltact::bench
