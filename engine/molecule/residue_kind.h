// Classifies a residue by its name. Internal to engine/molecule.
#pragma once

#include <string_view>

#include "engine/molecule/molecule.h"

namespace moltact {

/// True for the names of water: HOH, WAT, H2O, DOD, TIP3, SOL.
bool isWaterName(std::string_view residue);

/// The kind of `residue`. `atoms` are those of the whole molecule; `hetero` is true for HETATM records.
ResidueKind residueKind(const Residue& residue, const std::vector<Atom>& atoms, bool hetero);

}  // namespace moltact
