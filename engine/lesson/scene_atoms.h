// The atoms of a molecule that a scene hides or makes untouchable. Any thread but the haptic one.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/lesson/lesson.h"
#include "engine/molecule/molecule.h"

namespace moltact {

/// Atoms that are not drawn at their place in the molecule: those of `hide`, `remove` and `in-hand`, ascending.
std::vector<std::uint32_t> hiddenAtoms(const SceneSpec& scene, const Molecule& molecule);

/// Atoms that are not felt: those of `untouchable`, `remove` and `in-hand`, ascending.
std::vector<std::uint32_t> untouchableAtoms(const SceneSpec& scene, const Molecule& molecule);

/// Atoms that the hand holds, ascending.
std::vector<std::uint32_t> heldAtoms(const SceneSpec& scene, const Molecule& molecule);

/// The atoms of a selection that `remove` does not contain, ascending.
std::vector<std::uint32_t> presentAtoms(const Selection& atoms, const SceneSpec& scene, const Molecule& molecule);

/// True if these atoms are at least 90 % of the scene's remaining atoms. The centre of such a selection is close to the
/// molecule's centre and gives no viewing direction.
bool nearlyAllPresent(const std::vector<std::uint32_t>& present, const SceneSpec& scene, const Molecule& molecule);

/// The union of two ascending lists, ascending.
std::vector<std::uint32_t> atomsOfEither(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b);

}  // namespace moltact
