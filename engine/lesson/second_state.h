// The second structure of a scene: which molecule it is, and both laid on one another. Any thread but the haptic one.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/lesson/lesson.h"
#include "engine/molecule/molecule.h"
#include "engine/structure/superposition.h"

namespace moltact {

/// The molecule of the scene's `then`, read as its first one is; without a name where it has none.
NamedMolecule secondMolecule(const SceneSpec& scene);

/// The molecule that stands beside the scene's, read as it is there; without a name where there is none.
NamedMolecule besideMolecule(const SceneSpec& scene);

/// What a scene's key `then` says: "1ake", "1ake, superposed on chain A", "none". A problem has the column from 1.
Expected<SecondState> parseSecondState(std::string_view text);

/// The atoms by which the second structure is laid on the first; none: by all that lead.
std::vector<std::uint32_t> superposedOn(const SceneSpec& scene, const Molecule& molecule);

/// Both states of the scene's molecule, of which `other` is the second. A Problem where they do not go together.
Expected<TwoStates> statesOf(const SceneSpec& scene, const Molecule& molecule, const Molecule& other);

/// What the states are called: 0 the first, 1 the second.
std::string stateName(const SceneSpec& scene, int state);

}  // namespace moltact
