// Bodies, scenes and hand paths for the tests of the exact rigid body; deterministic functions of their arguments.
// Units: angstrom, radian.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/bench/scenes.h"
#include "engine/haptics/body/held_body.h"

namespace moltact::test {

/// A chain of `n` spheres of radius 1.2 whose neighbours are 1.5 apart, about its middle.
inline std::shared_ptr<const HeldBody> chainBody(int n, std::uint64_t seed) {
  scenes::Random random(seed);
  std::vector<Sphere> spheres;
  Vec3 at(0.0), way(1, 0, 0), middle(0.0);
  for (int k = 0; k < n; ++k) {
    spheres.push_back({at, random.uniform(1.0, 1.4)});
    middle += at / double(n);
    way = glm::normalize(way + 0.9 * random.direction());
    at += 1.5 * way;
  }
  for (Sphere& s : spheres) s.centre_A -= middle;
  return bodyOfSpheres(std::move(spheres));
}

/// A path of the hand over a scene: in from outside, then pressed `depth_A` deep and dragged and turned about, and out
/// at times. `jump_every` > 0: every so many ticks a jump to a place beside or inside.
inline std::vector<PoseA> bodyPath(const std::vector<Sphere>& scene, double reach_A, int ticks, std::uint64_t seed,
                                   double step_A, double turn_rad, double depth_A, int jump_every = 0) {
  scenes::Random random(seed);
  Vec3 low(1e9), high(-1e9);
  for (const Sphere& s : scene) low = glm::min(low, s.centre_A), high = glm::max(high, s.centre_A);
  const Vec3 middle = 0.5 * (low + high);
  const double radius = 0.5 * glm::length(high - low) / std::sqrt(3.0);
  Vec3 direction = random.direction(), drift = random.direction(), axis = random.direction();
  std::vector<PoseA> out;
  Quat turn = kNoRotation;
  double height = radius + reach_A + 6.0;
  double goal = radius + 0.5 * reach_A - depth_A;
  for (int k = 0; k < ticks; ++k) {
    if (k % 150 == 149) drift = random.direction(), axis = random.direction();
    if (k % 400 == 399)
      goal = radius + (k % 1200 == 1199 ? reach_A + 4.0 : random.uniform(-0.2, 1.0) * reach_A - depth_A);
    direction = glm::normalize(direction + drift * (0.7 * step_A / std::max(1.0, height)));
    height += std::clamp(goal - height, -step_A, step_A);
    turn = glm::normalize(glm::angleAxis(turn_rad, axis) * turn);
    Vec3 place = middle + direction * height;
    if (jump_every > 0 && k % jump_every == jump_every - 1)
      place = middle + random.direction() * random.uniform(0.0, radius + reach_A + 3.0);
    out.push_back({{place}, turn});
  }
  return out;
}

}  // namespace moltact::test
