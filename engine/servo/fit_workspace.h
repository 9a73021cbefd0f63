// How large a molecule lies under the hand. Pure; any thread.
#pragma once

#include <algorithm>

#include "engine/core/units.h"
#include "engine/haptics/ball_scene.h"

namespace moltact {

/// The scene's middle at the device's origin, its longest side across the reach of a hand (160 mm), but no atom so large or
/// small that it is no longer felt as one: 0.15 to 0.4 A a millimetre.
inline Workspace fitWorkspace(const BallScene& scene) {
  constexpr double kReach_mm = 160.0, kFinest = 0.15, kCoarsest = 0.4;
  const Vec3 size = scene.high_A() - scene.low_A();
  Workspace out;
  out.centre_A = 0.5 * (scene.low_A() + scene.high_A());
  out.A_per_mm = std::clamp(std::max({size.x, size.y, size.z}) / kReach_mm, kFinest, kCoarsest);
  return out;
}

}  // namespace moltact
