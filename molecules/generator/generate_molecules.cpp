// Writes the molecules that are built from published geometry into a folder, and what is cut out of the 2hhb.pdb that
// lies there: moltact_generate_molecules FOLDER
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>

#include "molecules/generator/pdb_writer.h"

int main(int argc, char** argv) {
  using namespace moltact::generator;
  if (argc != 2) {
    std::fprintf(stderr, "usage: moltact_generate_molecules FOLDER\n");
    return 2;
  }
  std::ifstream in(std::string(argv[1]) + "/2hhb.pdb", std::ios::binary);
  std::ostringstream entry;
  entry << in.rdbuf();
  if (entry.str().empty()) {
    std::fprintf(stderr, "%s/2hhb.pdb cannot be read; make it first with from_packages.sh\n", argv[1]);
    return 1;
  }
  const std::pair<const char*, std::string> made[] = {
      {"argon.pdb", makeArgon(1)},
      {"argon-pair.pdb", makeArgon(2)},
      {"argon-triangle.pdb", makeArgon(3)},
      {"water.pdb", makeWater()},
      {"benzene.pdb", makeBenzene()},
      {"alanine-pair.pdb", makeAlaninePair()},
      {"phenylalanine-pair.pdb", makePhenylalaninePair()},
      {"stearic-oleic.pdb", makeStearicOleic()},
      {"stearic-elaidic.pdb", makeStearicElaidic()},
      {"straight-neighbours.pdb", makeStraightNeighbours()},
      {"kinked-neighbours.pdb", makeKinkedNeighbours()},
      {"alpha-helix.pdb", makeAlphaHelix()},
      {"helix-pair.pdb", makeHelixPair()},
      {"beta-strand.pdb", makeBetaStrand()},
      {"b-dna.pdb", makeBDna()},
      {"haem-alpha.pdb", makeHaemPocket(entry.str(), 'A')},
      {"haem-beta.pdb", makeHaemPocket(entry.str(), 'B')},
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
