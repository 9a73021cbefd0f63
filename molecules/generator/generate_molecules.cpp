// Writes the molecules that are built from published geometry into a folder: moltact_generate_molecules
// FOLDER
#include <cstdio>
#include <fstream>
#include <string>

#include "molecules/generator/pdb_writer.h"

int main(int argc, char** argv) {
  using namespace moltact::generator;
  if (argc != 2) {
    std::fprintf(stderr, "usage: moltact_generate_molecules FOLDER\n");
    return 2;
  }
  const std::pair<const char*, std::string> made[] = {
      {"argon.pdb", makeArgon(1)}, {"argon-pair.pdb", makeArgon(2)}, {"argon-triangle.pdb", makeArgon(3)},
      {"water.pdb", makeWater()},  {"benzene.pdb", makeBenzene()},   {"alpha-helix.pdb", makeAlphaHelix()},
      {"b-dna.pdb", makeBDna()},
  };
  for (const auto& [name, text] : made) {
    const std::string path = std::string(argv[1]) + '/' + name;
    std::ofstream out(path, std::ios::binary);
    out << text;
    if (!out.flush()) {
      std::fprintf(stderr, "%s: cannot be written; check that the folder exists\n", path.c_str());
      return 1;
    }
  }
  return 0;
}
