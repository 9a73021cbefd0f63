// Fits a molecule into the workspace of the hand. Pure functions; any thread except the haptic one. Units: angstrom,
// millimetre.
#pragma once

#include <algorithm>

#include "engine/core/units.h"
#include "engine/device/device.h"
#include "engine/haptics/body/held_body.h"
#include "engine/haptics/sphere_grid.h"

namespace moltact {

/// Maps the scene's middle to the device's origin and its longest side to the reach of a hand (160 mm), limited to 0.15
/// to 0.4 A/mm: outside this range an atom would be too large or too small to be felt as one.
inline Workspace fitWorkspace(const SphereGrid& scene) {
  constexpr double kReach_mm = 160.0, kFinest = 0.15, kCoarsest = 0.4;
  const Vec3 size = scene.high_A() - scene.low_A();
  Workspace out;
  out.centre_A = 0.5 * (scene.low_A() + scene.high_A());
  out.A_per_mm = std::clamp(std::max({size.x, size.y, size.z}) / kReach_mm, kFinest, kCoarsest);
  return out;
}

/// The reach of a held device is limited by its workspace, which is usually less deep than a molecule. fitToDevice()
/// therefore leaves the middle of the workspace free, in front of the surface.
inline constexpr double kFreeFraction = 0.2, kMaxFree_mm = 20.0;  ///< fraction of the workspace's depth, and its limit

/// Fits the scene for a held device at the same scale, along the axes `rotation`. `toward` lies straight behind the
/// middle of the device's workspace. The first surface that the shape in the hand meets on its path there lies in front
/// of it, at kFreeFraction of the workspace's depth from the middle. Without such a surface, `toward` itself lies
/// there.
Workspace fitToDevice(const Workspace& scene, const SphereGrid& spheres, const HandShape& held, PointA toward,
                      const glm::dmat3& rotation, const DeviceSpecs& device);

/// For a hand inside the molecule: moves the molecule back along the device's z axis until the shape in the hand is
/// kRetraction_mm in front of it.
Workspace retracted(const Workspace& now, const SphereGrid& spheres, const HandShape& held, PointMm hand);

inline constexpr double kRetraction_mm = 5.0;

}  // namespace moltact
