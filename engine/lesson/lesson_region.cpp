#include "engine/lesson/lesson_region.h"

#include <algorithm>

#include "engine/lesson/scene_atoms.h"

namespace moltact {

std::optional<Region> magnifiedRegion(const SceneSpec& scene, const Molecule& molecule) {
  if (!scene.magnify.given()) return {};
  return regionAround(presentAtoms(scene.magnify, scene, molecule), molecule, scene.touch.probe_A);
}

std::optional<Region> zoomedRegion(const ViewSpec& view, const SceneSpec& scene, const Molecule& molecule,
                                   double probe_A) {
  if (!view.zoom.given()) return {};
  return regionAround(presentAtoms(view.zoom, scene, molecule), molecule, probe_A);
}

std::optional<Region> regionAround(std::span<const std::uint32_t> atoms, const Molecule& molecule, double grown_A) {
  if (atoms.empty()) return {};
  Region region;
  for (const std::uint32_t a : atoms) region.centre.A += molecule.spheres[a].centre_A / double(atoms.size());
  for (const std::uint32_t a : atoms) {
    const double out_A =
        glm::distance(molecule.spheres[a].centre_A, region.centre.A) + molecule.spheres[a].radius_A + grown_A;
    region.radius_A = std::max(region.radius_A, out_A);
  }
  return region;
}

}  // namespace moltact
