// The scenes in which haptic methods are known to fail, each with its motion and its applicable checks. Deterministic
// functions of the seed. Units: angstrom.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/bench/closed_loop.h"
#include "engine/bench/scenes.h"
#include "engine/haptics/interaction.h"

namespace moltact::bench {

/// The inputs of one tick.
struct StabilityTick {
  Vec3 place_A{0.0};  ///< target of the hand, or the HIP itself if it is controlled directly
  LoopFault fault = LoopFault::None;
  double probe_A = -1;   ///< probe radius to set before the tick; negative: unchanged
  bool swap = false;     ///< switch to the second molecule
  bool reset = false;    ///< reset the tracker
  int motion = -1;       ///< begin this one of the scene's motions; negative: go on
  double friction = -1;  ///< coefficient of friction to set before the tick; negative: unchanged
  int take = -1;         ///< hold this sphere by a spring (PullSpring) instead of touching; negative: unchanged
  bool let_go = false;   ///< touch again, from outside
};

/// A motion of all spheres from where they are to other places, at constant speed.
struct StabilityMotion {
  std::vector<Sphere> to;
  int ticks = 1;
};

struct StabilityScene {
  std::string name;
  std::string question;  ///< what the scene tests, one sentence
  scenes::Scene scene;
  std::optional<scenes::Scene> second{};  ///< the molecule that `swap` switches to
  bool hand = true;                       ///< closed loop with device and hand; false: the HIP is controlled directly
  bool energy = true;                     ///< energy is measured (small steps, nothing changes during contact)
  bool jump = true;                       ///< the step of the force is compared with that of the true surface
  std::size_t held_ticks = 0;             ///< final ticks in which the hand is held, for the residual jitter
  std::vector<StabilityTick> script{};
  std::vector<StabilityMotion> motions{};  ///< each begins after the one before has ended
  Friction friction{};                     ///< coefficient 0 in a scene without changes of it: the method alone is felt
  double stiffness_N_per_mm = 0;           ///< of the spring between HIP and SCP; 0: that of the loop

  /// True if the method is felt through a FrictionLayer.
  bool rough() const;
  /// True if the surface moves or has friction. These scenes have tables of their own.
  bool changing() const { return !motions.empty() || rough(); }
};

/// The scenes whose spheres move, and those with friction (moving_stability_scenes.cpp).
std::vector<StabilityScene> movingScenes();
std::vector<StabilityScene> frictionScenes(std::uint64_t seed);

/// All scenes, in the order of the tables.
std::vector<StabilityScene> stabilityScenes(std::uint64_t seed);

/// Rotates scene and motion as a whole about the middle of the scene by a random rotation. The orientation of sensor,
/// grid and triangles relative to the scene changes.
StabilityScene turned(StabilityScene scene, std::uint64_t seed);

/// Draw 0 contains the original scenes; each further draw has new random walks and a rotation.
std::vector<StabilityScene> drawnScenes(std::uint64_t seed, std::size_t draw);

/// The middle of the bounding box of a scene's centres.
Vec3 middleOf(const scenes::Scene& scene);

}  // namespace moltact::bench
