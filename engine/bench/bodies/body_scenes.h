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
  /// The spheres move to these positions and back from the first tick on. Each direction takes `motion_ticks`, and
  /// `motions` directions are made. Empty: the spheres do not move.
  std::vector<Sphere> swollen{};
  int motion_ticks = 0, motions = 0;
};

/// All scenes, in the order of the tables.
std::vector<BodyScene> bodyScenes(std::uint64_t seed);

/// A draw is one random variation of the scenes; draw 0 is unchanged. In each further draw a random rotation rotates
/// scene and motion as a whole, and the hand is shifted by 0.02 A in a random direction.
std::vector<BodyScene> drawnBodyScenes(std::uint64_t seed, std::size_t draw);

}  // namespace moltact::bench
