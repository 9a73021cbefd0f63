// The bonds and the secondary structure of one molecule, found when they are first wanted and kept: they hold for all
// its coordinates (Molecule::sameTopology). One thread at a time.
#pragma once

#include <optional>
#include <vector>

#include "engine/structure/bonds.h"
#include "engine/structure/secondary_structure.h"

namespace moltact {

class FoundStructure {
 public:
  /// findBonds(). The molecule is the same at every call, perhaps at other coordinates.
  const std::vector<Bond>& bonds(const Molecule& molecule) {
    if (!bonds_) bonds_ = findBonds(molecule);
    return *bonds_;
  }
  /// secondaryStructure(), likewise.
  const MoleculeStructure& secondary(const Molecule& molecule) {
    if (!secondary_) secondary_ = secondaryStructure(molecule);
    return *secondary_;
  }

 private:
  std::optional<std::vector<Bond>> bonds_;
  std::optional<MoleculeStructure> secondary_;
};

}  // namespace moltact
