// The region of the molecule that a scene magnifies or zooms to. Any thread but the haptic one. Unit: angstrom.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "engine/core/region.h"
#include "engine/lesson/lesson.h"
#include "engine/molecule/molecule.h"

namespace moltact {

/// A sphere around the magnified atoms, each enlarged by the radius of the scene's probe; nothing if the scene
/// magnifies none.
std::optional<Region> magnifiedRegion(const SceneSpec& scene, const Molecule& molecule);

/// A sphere around these atoms, each enlarged by `grown_A`; nothing for no atoms.
std::optional<Region> regionAround(std::span<const std::uint32_t> atoms, const Molecule& molecule, double grown_A);

/// The region that a view zooms to, with room for a probe; nothing if it shows the whole molecule.
std::optional<Region> zoomedRegion(const ViewSpec& view, const SceneSpec& scene, const Molecule& molecule,
                                   double probe_A);

}  // namespace moltact
