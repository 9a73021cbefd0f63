// The factor by which each atom multiplies the coefficient of friction, for the textures of
// engine/haptics/texture_choices.h. Any thread except the haptic one.
#pragma once

#include <memory>
#include <string_view>

#include "engine/haptics/friction.h"
#include "engine/molecule/molecule.h"

namespace moltact {

/// One factor per atom: 1 where the texture has no value. Null for "none" and for an unknown name.
std::shared_ptr<const Roughness> roughness(const Molecule& molecule, std::string_view texture);

}  // namespace moltact
