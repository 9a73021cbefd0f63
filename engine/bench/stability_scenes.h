// The scenes in which haptic methods are known to fail, each with its motion and the checks that mean
// something in it. Functions of the seed alone. Units: angstrom.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/bench/closed_loop.h"
#include "engine/bench/scenes.h"

namespace moltact::bench {

/// What one tick asks for.
struct StabilityTick {
  Vec3 place_A{0.0};  ///< where the hand is led, or the HIP itself where the scene is led directly
  LoopFault fault = LoopFault::None;
  double probe_A = -1;  ///< set this probe before the tick; negative: leave it
  bool swap = false;    ///< go on with the second molecule from here
  bool reset = false;   ///< begin anew from here
};

struct StabilityScene {
  std::string name;
  std::string question;  ///< what is asked of a method here, one sentence
  scenes::Scene scene;
  std::optional<scenes::Scene> second{};  ///< what `swap` brings
  bool hand = true;                       ///< closed loop with device and hand; false: the HIP is led directly
  bool energy = true;                     ///< energy has a meaning here (small steps, nothing changes under the finger)
  bool jump = true;                       ///< so has the step of the force against the true surface's
  std::size_t held_ticks = 0;             ///< at the end the hand is held for so long, for the residual jitter
  std::vector<StabilityTick> script{};
};

/// All scenes, in the order of the matrix.
std::vector<StabilityScene> stabilityScenes(std::uint64_t seed);

/// Scene and motion turned as a whole round the middle of the scene, in a way that the seed draws: sensor,
/// grid and triangles then lie otherwise, the question stays the same.
StabilityScene turned(StabilityScene scene, std::uint64_t seed);

/// Draw 0 is the scenes as they are written; each further one has its random walks drawn anew and is turned.
std::vector<StabilityScene> drawnScenes(std::uint64_t seed, std::size_t draw);

/// The middle of the box round a scene's centres.
Vec3 middleOf(const scenes::Scene& scene);

}  // namespace moltact::bench
