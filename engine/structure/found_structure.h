// Caches the bonds and the secondary structure of one molecule, computed at first use. They apply to all its
// coordinates (Molecule::sameTopology). One thread at a time.
#pragma once

#include <optional>
#include <vector>

#include "engine/structure/bonds.h"
#include "engine/structure/secondary_structure.h"

namespace moltact {

class FoundStructure {
 public:
  /// findBonds(). All calls must pass the same molecule, possibly with different coordinates.
  const std::vector<Bond>& bonds(const Molecule& molecule) {
    if (!bonds_) bonds_ = findBonds(molecule);
    return *bonds_;
  }
  /// secondaryStructure(), with the same condition.
  const MoleculeStructure& secondary(const Molecule& molecule) {
    if (!secondary_) secondary_ = secondaryStructure(molecule);
    return *secondary_;
  }

 private:
  std::optional<std::vector<Bond>> bonds_;
  std::optional<MoleculeStructure> secondary_;
};

}  // namespace moltact
