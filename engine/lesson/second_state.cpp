#include "engine/lesson/second_state.h"

#include <utility>

#include "engine/core/utf8.h"
#include "engine/lesson/source_text.h"
#include "engine/molecule/side_by_side.h"

namespace moltact {

NamedMolecule secondMolecule(const SceneSpec& scene) {
  NamedMolecule out = scene.molecule;
  out.name = scene.then.molecule;
  return out;
}

NamedMolecule besideMolecule(const SceneSpec& scene) {
  const ReadOptions& reading = scene.molecule.reading;
  return {reading.beside, besideReading(reading)};
}

Expected<SecondState> parseSecondState(std::string_view text) {
  constexpr std::string_view kSuperposed = ", superposed on ";
  const std::size_t comma = text.find(kSuperposed);
  SecondState then;
  then.molecule = std::string(stripped(text.substr(0, comma)));
  if (then.molecule == "none") then.molecule.clear();
  if (comma == std::string_view::npos) return then;
  Expected<Selection> atoms = parseSelection(stripped(text.substr(comma + kSuperposed.size())));
  if (!atoms) {
    Problem problem = atoms.problem();
    problem.column += characterCount(text.substr(0, comma + kSuperposed.size()));
    return problem;
  }
  then.superposed_on = *std::move(atoms);
  return then;
}

Expected<TrajectorySpec> parseTrajectory(std::string_view text) {
  constexpr std::string_view kNot = ", not superposed";
  TrajectorySpec out;
  if (const std::string_view whole = stripped(text); whole.ends_with(kNot)) {
    out.superposed = false;
    text = whole.substr(0, whole.size() - kNot.size());
  }
  // The rest is written as a second structure is.
  Expected<SecondState> parsed = parseSecondState(text);
  if (!parsed) return parsed.problem();
  out.file = std::move(parsed->molecule);
  out.superposed_on = std::move(parsed->superposed_on);
  return out;
}

std::vector<std::uint32_t> superposedOn(const SceneSpec& scene, const Molecule& molecule) {
  const Selection& atoms = scene.then.superposed_on;
  return atoms.given() ? atoms.select(molecule) : std::vector<std::uint32_t>();
}

Expected<TwoStates> statesOf(const SceneSpec& scene, const Molecule& molecule, const Molecule& other) {
  return twoStates(molecule, other, superposedOn(scene, molecule));
}

std::string stateName(const SceneSpec& scene, int state) {
  const SecondState& then = scene.then;
  if (then.states.size() == 2) return then.states[std::size_t(state)];
  return state == 0 ? scene.molecule.name : then.molecule;
}

}  // namespace moltact
