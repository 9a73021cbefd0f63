#include "molecules/generator/pdb_writer.h"

#include <cstdio>

namespace moltact::generator {

std::string writePdb(const std::string& title, const std::vector<std::string>& remarks,
                     const std::vector<MadeAtom>& atoms) {
  std::string out = "TITLE     " + title + '\n';
  for (const std::string& remark : remarks) out += "REMARK   1 " + remark + '\n';
  int serial = 0;
  for (std::size_t i = 0; i < atoms.size(); ++i) {
    const MadeAtom& a = atoms[i];
    // In the four columns of the name, one-letter elements begin in the second column.
    const char* pad = a.name.size() < 4 && a.element.size() == 1 ? " " : "";
    char line[96];
    std::snprintf(line, sizeof line, "%-6s%5d %s%-*s %3s %c%4d    %8.3f%8.3f%8.3f%6.2f%6.2f          %2s  \n",
                  a.hetero ? "HETATM" : "ATOM", ++serial, pad, pad[0] ? 3 : 4, a.name.c_str(), a.residue.c_str(),
                  a.chain, a.number, a.position_A.x + 0.0, a.position_A.y + 0.0, a.position_A.z + 0.0, 1.0, 0.0,
                  a.element.c_str());
    out += line;
    const bool ends = i + 1 == atoms.size() || atoms[i + 1].chain != a.chain;
    if (ends && !a.hetero) {
      std::snprintf(line, sizeof line, "TER   %5d      %3s %c%4d\n", ++serial, a.residue.c_str(), a.chain, a.number);
      out += line;
    }
  }
  return out + "END\n";
}

}  // namespace moltact::generator
