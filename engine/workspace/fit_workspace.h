// Places a molecule in the workspace of the hand. Pure; any thread but the haptic one. Units: angstrom, millimetre.
#pragma once

#include <algorithm>

#include "engine/core/units.h"
#include "engine/device/device.h"
#include "engine/haptics/body/held_body.h"
#include "engine/haptics/sphere_grid.h"

namespace moltact {

/// Puts the scene's middle at the device's origin and its longest side across the reach of a hand (160 mm), within 0.15
/// to 0.4 A/mm: outside that range an atom would be too large or too small to be felt as one.
inline Workspace fitWorkspace(const SphereGrid& scene) {
  constexpr double kReach_mm = 160.0, kFinest = 0.15, kCoarsest = 0.4;
  const Vec3 size = scene.high_A() - scene.low_A();
  Workspace out;
  out.centre_A = 0.5 * (scene.low_A() + scene.high_A());
  out.A_per_mm = std::clamp(std::max({size.x, size.y, size.z}) / kReach_mm, kFinest, kCoarsest);
  return out;
}

/// A held hand reaches no farther than its device's workspace, which is mostly less deep than a molecule: the middle of
/// the workspace lies free in front of the surface.
inline constexpr double kFreeFraction = 0.2, kMaxFree_mm = 20.0;  ///< this fraction of the workspace's depth, at most

/// The same scale for a held hand, along the axes `rotation`. `toward` lies straight behind the middle of the device's
/// workspace. The surface that what is in the hand meets first on its path there lies in front of it,
/// kFreeFraction of the workspace's depth from the middle. Where it meets nothing, `toward` itself lies there.
Workspace fitToDevice(const Workspace& scene, const SphereGrid& spheres, const HandShape& held, PointA toward,
                      const glm::dmat3& rotation, const DeviceSpecs& device);

/// For a hand that is inside the molecule: moves the molecule back along the device's z-axis until what is in the hand
/// is kDrawnBack_mm before it.
Workspace retracted(const Workspace& now, const SphereGrid& spheres, const HandShape& held, PointMm hand);

inline constexpr double kDrawnBack_mm = 5.0;

}  // namespace moltact
