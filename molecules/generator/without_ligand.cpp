// HIV-1 protease of PDB entry 1HPV without the drug and the water in its tunnel, and the drug alone. Every atom keeps
// its place.
#include <sstream>

#include "molecules/generator/pdb_writer.h"

namespace moltact::generator {

std::string makeEmptyProtease(const std::string& entry) {
  std::string out =
      "TITLE     HIV-1 PROTEASE, ITS TUNNEL EMPTY\n"
      "REMARK   1 FROM PDB ENTRY 1HPV (CC0): ATOM AND TER, UNCHANGED\n"
      "REMARK   1 LEFT OUT: THE INHIBITOR AMPRENAVIR, WATER\n"
      "REMARK   1 MADE BY MOLTACT_GENERATE_MOLECULES\n";
  std::istringstream lines(entry);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("ATOM  ") || line.starts_with("TER")) out += line + '\n';
  return out + "END\n";
}

std::string makeAmprenavir(const std::string& entry) {
  std::string out =
      "TITLE     AMPRENAVIR AS IT LIES IN HIV-1 PROTEASE\n"
      "REMARK   1 FROM PDB ENTRY 1HPV (CC0): RESIDUE 478, UNCHANGED\n"
      "REMARK   1 LEFT OUT: THE PROTEIN, WATER; THE CRYSTAL HAS NO HYDROGENS\n"
      "REMARK   1 MADE BY MOLTACT_GENERATE_MOLECULES\n";
  std::istringstream lines(entry);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("HETATM") && line.substr(17, 3) == "478") out += line + '\n';
  return out + "END\n";
}

}  // namespace moltact::generator
