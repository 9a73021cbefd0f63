#include "engine/workspace/fit_workspace.h"

#include <cmath>

#include "engine/haptics/sweep.h"

namespace moltact {
namespace {

// The distance by which the surface lies in front of `place` (toward `back`, unit: angstrom), met from outside by the
// shape in the hand; negative: behind it. Returns 0 if there is no surface.
double surfaceBefore_A(const SphereGrid& spheres, const HandShape& held, const Vec3& place, const Vec3& back) {
  const double far = glm::distance(spheres.low_A(), spheres.high_A()) + 2.0 * held.reach_A() + 1.0 +
                     glm::distance(place, 0.5 * (spheres.low_A() + spheres.high_A()));
  const Hit hit = sweep(spheres, held, place + back * far, place - back * far);
  return hit.sphere >= 0 ? far * (1.0 - 2.0 * hit.t) : 0.0;
}

}  // namespace

Workspace fitToDevice(const Workspace& scene, const SphereGrid& spheres, const HandShape& held, PointA toward,
                      const glm::dmat3& rotation, const DeviceSpecs& device) {
  const double depth_mm =
      std::isfinite(device.workspace_mm.z) ? std::max(0.0, device.workspace_mm.z) : DeviceSpecs{}.workspace_mm.z;
  Workspace out = scene;
  out.rotation = rotation;
  const double free_A = out.A_per_mm * std::min(kMaxFree_mm, kFreeFraction * depth_mm);
  out.centre_A = toward.A + rotation[2] * (surfaceBefore_A(spheres, held, toward.A, rotation[2]) + free_A);
  return out;
}

Workspace retracted(const Workspace& now, const SphereGrid& spheres, const HandShape& held, PointMm hand) {
  Workspace out = now;
  const double before_A =
      surfaceBefore_A(spheres, held, now.toMolecule(hand).A, now.rotation[2]) + kRetraction_mm * now.A_per_mm;
  out.centre_A += now.rotation[2] * std::max(0.0, before_A);
  return out;
}

}  // namespace moltact
