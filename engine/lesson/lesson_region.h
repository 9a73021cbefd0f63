// Which part of its molecule a scene magnifies or comes close to. Any thread but the haptic one. Units: angstrom.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "engine/core/region.h"
#include "engine/lesson/lesson.h"
#include "engine/molecule/molecule.h"

namespace moltact {

/// A sphere round the atoms that the scene magnifies, as large as they are felt with its probe; nothing where it
/// magnifies none.
std::optional<Region> magnifiedRegion(const SceneSpec& scene, const Molecule& molecule);

/// A sphere round these atoms, each as much larger as `grown_A`; nothing for none.
std::optional<Region> regionAround(std::span<const std::uint32_t> atoms, const Molecule& molecule, double grown_A);

/// What a view of the scene comes close to, with room for a probe; nothing where it shows the whole.
std::optional<Region> zoomedRegion(const ViewSpec& view, const SceneSpec& scene, const Molecule& molecule,
                                   double probe_A);

}  // namespace moltact
