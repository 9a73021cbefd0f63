// Scenes of 3 to 60 spheres with almost degenerate intersections, which trackers must survive. Pure functions of a
// seed, with the same numbers on every machine. Unit: angstrom.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/bench/scenes.h"

namespace moltact::test {

struct DegenerateScene {
  std::string family;
  scenes::Scene scene;
  std::vector<Vec3> special;  ///< intersections of surfaces, centres, points on axes: targets for the hand
};

/// The scene of this seed; consecutive seeds cycle through the families.
DegenerateScene degenerateScene(std::uint64_t seed);

/// The number of families.
int degenerateFamilies();

/// HIP positions. Depending on the seed, the path jumps to special points and away, glides over the surface, or passes
/// straight through.
std::vector<Vec3> degeneratePath(const DegenerateScene& scene, int ticks, std::uint64_t seed);

}  // namespace moltact::test
