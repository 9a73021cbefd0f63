// Which part of its molecule a scene magnifies. Any thread but the haptic one. Units: angstrom.
#pragma once

#include <optional>

#include "engine/core/region.h"
#include "engine/lesson/lesson.h"
#include "engine/molecule/molecule.h"

namespace moltact {

/// A ball round the atoms that the scene magnifies, as large as they are felt with its probe; nothing where it
/// magnifies none.
std::optional<Region> magnifiedRegion(const SceneSpec& scene, const Molecule& molecule);

}  // namespace moltact
