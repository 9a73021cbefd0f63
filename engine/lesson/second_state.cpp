#include "engine/lesson/second_state.h"

namespace moltact {

NamedMolecule secondMolecule(const SceneSpec& scene) {
  NamedMolecule out = scene.molecule;
  out.name = scene.then.molecule;
  return out;
}

std::vector<std::uint32_t> superposedOn(const SceneSpec& scene, const Molecule& molecule) {
  const Selection& atoms = scene.then.superposed_on;
  return atoms.given() ? atoms.select(molecule) : std::vector<std::uint32_t>();
}

Expected<TwoStates> statesOf(const SceneSpec& scene, const Molecule& molecule, const Molecule& other) {
  return twoStates(molecule, other, superposedOn(scene, molecule));
}

Molecule movedTo(const Molecule& molecule, const std::vector<Ball>& places) {
  Molecule out = molecule;
  for (std::size_t i = 0; i < out.atoms.size() && i < places.size(); ++i) out.atoms[i].position.A = places[i].centre_A;
  return out;
}

std::string stateName(const SceneSpec& scene, int state) {
  const SecondState& then = scene.then;
  if (then.states.size() == 2) return then.states[std::size_t(state)];
  return state == 0 ? scene.molecule.name : then.molecule;
}

}  // namespace moltact
