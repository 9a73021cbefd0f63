// Which atoms of its molecule a scene hides from the eye and from the hand. Any thread but the haptic one.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/lesson/lesson.h"
#include "engine/molecule/molecule.h"

namespace moltact {

/// Atoms that are not drawn where the molecule is: those of `hide`, `remove` and `in-hand`, ascending.
std::vector<std::uint32_t> hiddenAtoms(const SceneSpec& scene, const Molecule& molecule);

/// Atoms that nothing feels: those of `untouchable`, `remove` and `in-hand`, ascending.
std::vector<std::uint32_t> untouchableAtoms(const SceneSpec& scene, const Molecule& molecule);

/// Atoms that the hand holds, ascending.
std::vector<std::uint32_t> heldAtoms(const SceneSpec& scene, const Molecule& molecule);

/// Those of a selection that the scene has not taken out by `remove`, ascending.
std::vector<std::uint32_t> presentAtoms(const Selection& atoms, const SceneSpec& scene, const Molecule& molecule);

/// Whether these present atoms are at least 90 % of those that the scene has left: the middle of such a selection is that of
/// the molecule, and gives no direction to look from.
bool nearlyAllPresent(const std::vector<std::uint32_t>& present, const SceneSpec& scene, const Molecule& molecule);

/// The atoms of either list, ascending; both must be so.
std::vector<std::uint32_t> atomsOfEither(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b);

}  // namespace moltact
