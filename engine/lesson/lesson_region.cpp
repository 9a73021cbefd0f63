#include "engine/lesson/lesson_region.h"

#include <algorithm>

namespace moltact {

std::optional<Region> magnifiedRegion(const SceneSpec& scene, const Molecule& molecule) {
  if (!scene.magnify.given()) return {};
  const std::vector<std::uint32_t> atoms = scene.magnify.select(molecule);
  if (atoms.empty()) return {};
  Region region;
  for (const std::uint32_t a : atoms) region.centre.A += molecule.atoms[a].position.A / double(atoms.size());
  for (const std::uint32_t a : atoms) {
    const double out_A =
        glm::distance(molecule.atoms[a].position.A, region.centre.A) + molecule.atoms[a].radius_A + scene.touch.probe_A;
    region.radius_A = std::max(region.radius_A, out_A);
  }
  return region;
}

}  // namespace moltact
