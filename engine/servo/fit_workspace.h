// How a molecule lies under the hand. Pure; any thread but the haptic one. Units: angstrom, millimetre.
#pragma once

#include <algorithm>

#include "engine/core/units.h"
#include "engine/device/device.h"
#include "engine/haptics/ball_scene.h"

namespace moltact {

/// The scene's middle at the device's origin, its longest side across the reach of a hand (160 mm), but no atom so
/// large or small that it is no longer felt as one: 0.15 to 0.4 A a millimetre.
inline Workspace fitWorkspace(const BallScene& scene) {
  constexpr double kReach_mm = 160.0, kFinest = 0.15, kCoarsest = 0.4;
  const Vec3 size = scene.high_A() - scene.low_A();
  Workspace out;
  out.centre_A = 0.5 * (scene.low_A() + scene.high_A());
  out.A_per_mm = std::clamp(std::max({size.x, size.y, size.z}) / kReach_mm, kFinest, kCoarsest);
  return out;
}

/// A hand that is held reaches no farther than its device's room, which is mostly less deep than a molecule: the room's
/// middle lies free before the surface.
inline constexpr double kFreeFraction = 0.2, kMostFree_mm = 20.0;  ///< so much of the room's depth, and no more

/// The same scale for a held hand, along the axes `turn`: straight behind the middle of the device's room lies
/// `toward`, and before it the surface that a probe meets first on its way there, at kFreeFraction of the room's depth
/// from the middle. Where nothing lies on that way, `toward` itself.
Workspace beforeHand(const Workspace& scene, const BallScene& balls, double probe_A, PointA toward,
                     const glm::dmat3& turn, const DeviceSpecs& device);

/// For a hand that is inside: the molecule drawn back along the device's z-axis until the probe is kDrawnBack_mm before
/// it.
Workspace drawnBack(const Workspace& now, const BallScene& balls, double probe_A, PointMm hand);

inline constexpr double kDrawnBack_mm = 5.0;

}  // namespace moltact
