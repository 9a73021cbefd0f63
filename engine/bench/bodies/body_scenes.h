// The scenes in which methods for a rigid body are known to fail, each with the motion of the hand. Deterministic functions
// of the seed. Units: angstrom, radian.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/sphere.h"
#include "engine/haptics/body/held_body.h"

namespace moltact::bench {

struct BodyScene {
  std::string name;
  std::string question;  ///< what the scene tests, one sentence
  std::vector<Sphere> spheres;
  std::shared_ptr<const HeldBody> body;
  std::vector<PoseA> path;     ///< one pose of the hand per tick; begins free of overlap
  std::size_t held_ticks = 0;  ///< final ticks in which the hand stands still
  /// From the first tick the spheres move to these and back, in `motion_ticks` either way, until `motions` are done; empty:
  /// they stand still.
  std::vector<Sphere> swollen{};
  int motion_ticks = 0, motions = 0;
};

/// All scenes, in the order of the tables.
std::vector<BodyScene> bodyScenes(std::uint64_t seed);

/// Draw 0 contains the original scenes. In each further draw scene and motion are rotated as a whole by a random rotation,
/// and the hand is shifted by 0.02 A in a random direction.
std::vector<BodyScene> drawnBodyScenes(std::uint64_t seed, std::size_t draw);

}  // namespace moltact::bench
