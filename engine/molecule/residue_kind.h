// The kind of residue that a name stands for. Inside engine/molecule only.
#pragma once

#include <string_view>

#include "engine/molecule/molecule.h"

namespace moltact {

/// True for the names that water goes by: HOH, WAT, H2O, DOD, TIP3, SOL.
bool isWaterName(std::string_view residue);

/// The kind of `residue`, whose atoms are `atoms`; `hetero` says that the file calls it HETATM.
ResidueKind residueKind(const Residue& residue, const std::vector<Atom>& atoms, bool hetero);

}  // namespace moltact
