// The names, arrows, measurements and marks of a scene, prepared for the picture of a molecule. Pure functions;
// window's thread.
#pragma once

#include <memory>
#include <vector>

#include "engine/lesson/lesson.h"
#include "engine/render/annotations.h"
#include "engine/render/view_scene.h"

namespace moltact {

/// Names, arrows, measurements and hydrogen bonds; null if the scene has none.
std::shared_ptr<const Annotations> annotationsOf(const SceneSpec& scene, const Molecule& molecule);

/// The marked atoms with their colours and names; null if there are none. A mark without a colour gets the next unused
/// one. Each colour's shade can be distinguished from the others with every kind of colour vision (shadesApart).
std::shared_ptr<const std::vector<OwnColour>> marksOf(const SceneSpec& scene, const Molecule& molecule);

/// The name of an atom, its residue or its chain in the picture: "CA", "Glu 35", "chain A".
std::string atomLabel(const Molecule& molecule, std::uint32_t atom);

/// A measurement between the centres of two to four atoms, with its value.
Annotations::Measure measureBetween(const Molecule& molecule, std::span<const std::uint32_t> atoms);

}  // namespace moltact
