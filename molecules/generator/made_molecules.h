// All molecules of the library that the project generates instead of taking them from a database.
#pragma once

#include <string>
#include <vector>

namespace moltact::generator {

struct MadeMolecule {
  const char* file;  ///< file name in the library's folder: "argon.pdb"
  std::string text;  ///< the whole file
};

/// Generates all molecules. Some are parts of the library's 2hhb.pdb and 1hpv.pdb, whose texts are the arguments.
std::vector<MadeMolecule> madeMolecules(const std::string& haemoglobin, const std::string& protease);

}  // namespace moltact::generator
