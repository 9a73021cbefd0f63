#include "engine/lesson/scene_atoms.h"

#include <algorithm>
#include <iterator>

namespace moltact {
namespace {

std::vector<std::uint32_t> selected(const Selection& atoms, const Molecule& molecule) {
  return atoms.given() ? atoms.select(molecule) : std::vector<std::uint32_t>();
}

}  // namespace

std::vector<std::uint32_t> atomsOfEither(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
  std::vector<std::uint32_t> out;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(out));
  return out;
}

std::vector<std::uint32_t> presentAtoms(const Selection& atoms, const SceneSpec& scene, const Molecule& molecule) {
  const std::vector<std::uint32_t> all = selected(atoms, molecule), removed = selected(scene.remove, molecule);
  std::vector<std::uint32_t> out;
  std::set_difference(all.begin(), all.end(), removed.begin(), removed.end(), std::back_inserter(out));
  return out;
}

bool nearlyAllPresent(const std::vector<std::uint32_t>& present, const SceneSpec& scene, const Molecule& molecule) {
  const std::size_t left = molecule.atoms.size() - selected(scene.remove, molecule).size();
  return !present.empty() && present.size() * 10 >= left * 9;
}

std::vector<std::uint32_t> hiddenAtoms(const SceneSpec& scene, const Molecule& molecule) {
  return atomsOfEither(atomsOfEither(selected(scene.hide, molecule), selected(scene.remove, molecule)),
                       heldAtoms(scene, molecule));
}

std::vector<std::uint32_t> untouchableAtoms(const SceneSpec& scene, const Molecule& molecule) {
  return atomsOfEither(atomsOfEither(selected(scene.untouchable, molecule), selected(scene.remove, molecule)),
                       heldAtoms(scene, molecule));
}

std::vector<std::uint32_t> heldAtoms(const SceneSpec& scene, const Molecule& molecule) {
  return selected(scene.in_hand, molecule);
}

}  // namespace moltact
