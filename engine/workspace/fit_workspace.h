// Fits a molecule into the workspace of the hand. Pure functions; any thread except the haptic one. Units: angstrom,
// millimetre.
#pragma once

#include <algorithm>

#include "engine/core/units.h"
#include "engine/device/device.h"
#include "engine/haptics/body/held_body.h"
#include "engine/haptics/sphere_grid.h"

namespace moltact {

/// Maps the middle of the scene's box to the device's origin, and scales the longest side of the box to 160 mm, the reach
/// of a hand. The scale is limited to 0.15 to 0.4 A/mm: outside this range an atom would be too large or too small to be
/// felt as one.
inline Workspace fitWorkspace(const SphereGrid& scene) {
  constexpr double kReach_mm = 160.0, kFinest = 0.15, kCoarsest = 0.4;
  const Vec3 size = scene.high_A() - scene.low_A();
  Workspace out;
  out.centre_A = 0.5 * (scene.low_A() + scene.high_A());
  out.A_per_mm = std::clamp(std::max({size.x, size.y, size.z}) / kReach_mm, kFinest, kCoarsest);
  return out;
}

/// The workspace limits the reach of a held device and is usually less deep than a molecule. fitToDevice() therefore
/// places the surface behind the middle of the workspace.
inline constexpr double kFreeFraction = 0.2, kMaxFree_mm = 20.0;  ///< fraction of the workspace's depth, and its limit

/// Fits the scene for a held device at the same scale, along the axes `rotation`. `toward` lies on the line from the user
/// through the middle of the device's workspace. The first surface that the shape in the hand meets on this line lies
/// behind the middle, by kFreeFraction of the workspace's depth and at most kMaxFree_mm. If there is none, `toward`
/// itself lies there.
Workspace fitToDevice(const Workspace& scene, const SphereGrid& spheres, const HandShape& held, PointA toward,
                      const glm::dmat3& rotation, const DeviceSpecs& device);

/// For a hand inside the molecule: moves the molecule back along the device's z axis until the shape in the hand is
/// kRetraction_mm in front of it.
Workspace retracted(const Workspace& now, const SphereGrid& spheres, const HandShape& held, PointMm hand);

inline constexpr double kRetraction_mm = 5.0;

}  // namespace moltact
