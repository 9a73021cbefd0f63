// The second structure of a scene: its molecule and its superposition on the first. Any thread but the haptic one.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/lesson/lesson.h"
#include "engine/molecule/molecule.h"
#include "engine/structure/superposition.h"

namespace moltact {

/// The molecule of the scene's `then`, with the reading options of the first; without a name if there is none.
NamedMolecule secondMolecule(const SceneSpec& scene);

/// The molecule beside the scene's, with the same reading options; without a name if there is none.
NamedMolecule besideMolecule(const SceneSpec& scene);

/// Parses the value of the key `then`: "1ake", "1ake, superposed on chain A", "none". A Problem has the column from 1.
Expected<SecondState> parseSecondState(std::string_view text);

/// Parses the value of the key `trajectory`: "md.xtc", "md.xtc, superposed on chain A", "md.xtc, not superposed", "none".
/// A Problem has the column from 1.
Expected<TrajectorySpec> parseTrajectory(std::string_view text);

/// The atoms used for the superposition; empty: the default atoms.
std::vector<std::uint32_t> superposedOn(const SceneSpec& scene, const Molecule& molecule);

/// Both structures of the scene's molecule; `other` is the second. A Problem if they cannot be superposed.
Expected<TwoStates> statesOf(const SceneSpec& scene, const Molecule& molecule, const Molecule& other);

/// The name of a structure: 0 the first, 1 the second.
std::string stateName(const SceneSpec& scene, int state);

}  // namespace moltact
