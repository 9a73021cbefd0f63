// The scenes in which haptic methods are known to fail, each with its motion and the checks that have a meaning in it.
// Functions of the seed alone. Units: angstrom.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/bench/closed_loop.h"
#include "engine/bench/scenes.h"

namespace moltact::bench {

/// The requests of one tick.
struct StabilityTick {
  Vec3 place_A{0.0};  ///< where the hand is led, or the HIP itself where the scene is led directly
  LoopFault fault = LoopFault::None;
  double probe_A = -1;  ///< set this probe before the tick; negative: leave it
  bool swap = false;    ///< continue with the second molecule from here
  bool reset = false;   ///< reset from here
};

struct StabilityScene {
  std::string name;
  std::string question;  ///< the question that the scene asks of a method, one sentence
  scenes::Scene scene;
  std::optional<scenes::Scene> second{};  ///< the molecule that `swap` switches to
  bool hand = true;                       ///< closed loop with device and hand; false: the HIP is led directly
  bool energy = true;                     ///< energy has a meaning here (small steps, nothing changes under the finger)
  bool jump = true;                       ///< so has the step of the force against the true surface's
  std::size_t held_ticks = 0;             ///< at the end the hand is held for so long, for the residual jitter
  std::vector<StabilityTick> script{};
};

/// All scenes, in the order of the matrix.
std::vector<StabilityScene> stabilityScenes(std::uint64_t seed);

/// Scene and motion rotated as a whole round the middle of the scene, by a rotation that the seed draws: sensor, grid
/// and triangles then lie differently, the question stays the same.
StabilityScene turned(StabilityScene scene, std::uint64_t seed);

/// Draw 0 is the scenes as written; each further draw has new random walks and is rotated.
std::vector<StabilityScene> drawnScenes(std::uint64_t seed, std::size_t draw);

/// The middle of the box round a scene's centres.
Vec3 middleOf(const scenes::Scene& scene);

}  // namespace moltact::bench
