// Statistics of a molecule, for the screen and `moltact info`. Units: angstrom.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/molecule/molecule.h"

namespace moltact {

struct MoleculeSummary {
  std::size_t atoms = 0;
  std::size_t residues = 0;
  std::size_t chains = 0;  ///< distinct chain names
  std::size_t waters = 0;  ///< water molecules among the residues
  std::size_t models = 1;  ///< in the file
  std::size_t waters_left_out = 0;
  std::size_t alternates_left_out = 0;
  std::vector<std::string> chain_names;         ///< in the order of the file
  std::map<std::string, std::size_t> elements;  ///< atoms by symbol, "?" for the unknown
  std::map<std::string, std::size_t> ligands;   ///< residues by name: ligands and ions
  Vec3 low_A{0.0}, high_A{0.0};                 ///< corners of the bounding box of the atoms' centres
};

MoleculeSummary summarise(const Molecule& molecule);

}  // namespace moltact
