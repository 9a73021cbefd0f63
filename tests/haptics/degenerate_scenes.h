// Scenes of 3 to 60 spheres in which surfaces meet in places that rounding can hardly tell: what a tracker must survive.
// Pure functions of a seed, with the same numbers on every machine. Units: angstrom.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/bench/scenes.h"

namespace moltact::test {

struct DegenerateScene {
  std::string family;
  scenes::Scene scene;
  std::vector<Vec3> special;  ///< where surfaces meet, centres, places on axes: where a hand is led
};

/// The scene of this seed; the families take turns.
DegenerateScene degenerateScene(std::uint64_t seed);

/// How many families there are.
int degenerateFamilies();

/// HIP places: by seed jumps to special places and away, a glide over the surface, or passes right through.
std::vector<Vec3> degeneratePath(const DegenerateScene& scene, int ticks, std::uint64_t seed);

}  // namespace moltact::test
