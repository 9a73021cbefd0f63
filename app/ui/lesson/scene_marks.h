// What a scene names, points at, measures and marks, as the picture of a molecule needs it. Pure functions; window's
// thread, at a person's pace.
#pragma once

#include <memory>
#include <vector>

#include "engine/lesson/lesson.h"
#include "engine/render/annotations.h"
#include "engine/render/view_scene.h"

namespace moltact {

/// Names, arrows, measures and hydrogen bonds; null where the scene has none.
std::shared_ptr<const Annotations> annotationsOf(const SceneSpec& scene, const Molecule& molecule);

/// The atoms of its marks with their colours and names; null where it has none. A mark without a colour gets the next one
/// that no other has; each is a shade of its colour that every kind of sight tells from the others (shadesApart).
std::shared_ptr<const std::vector<OwnColour>> marksOf(const SceneSpec& scene, const Molecule& molecule);

/// The name of an atom, its residue or its chain over the picture: "CA", "Glu 35", "chain A".
std::string atomLabel(const Molecule& molecule, std::uint32_t atom);

/// A measure between the middles of atoms, with its value; two to four of them.
Annotations::Measure measureBetween(const Molecule& molecule, std::span<const std::uint32_t> atoms);

}  // namespace moltact
