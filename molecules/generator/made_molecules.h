// Every molecule of the library that is made here and was not taken from a database.
#pragma once

#include <string>
#include <vector>

namespace moltact::generator {

struct MadeMolecule {
  const char* file;  ///< its name in the library's folder: "argon.pdb"
  std::string text;  ///< the whole file
};

/// From the texts of the library's 2hhb.pdb and 1hpv.pdb, of which some are parts.
std::vector<MadeMolecule> madeMolecules(const std::string& haemoglobin, const std::string& protease);

}  // namespace moltact::generator
