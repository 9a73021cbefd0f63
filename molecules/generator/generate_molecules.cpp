// Writes the molecules built from published geometry, and those cut out of 2hhb.pdb and 1hpv.pdb, into the folder of
// these two files: moltact_generate_molecules FOLDER
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>

#include "molecules/generator/made_molecules.h"

int main(int argc, char** argv) {
  using namespace moltact::generator;
  if (argc != 2) {
    std::fprintf(stderr, "usage: moltact_generate_molecules FOLDER\n");
    return 2;
  }
  const auto contentOf = [&](const char* name) {
    std::ifstream in(std::string(argv[1]) + '/' + name, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (text.str().empty())
      std::fprintf(stderr, "%s/%s cannot be read; make it first with from_packages.sh\n", argv[1], name);
    return text.str();
  };
  const std::string haemoglobin = contentOf("2hhb.pdb"), protease = contentOf("1hpv.pdb");
  if (haemoglobin.empty() || protease.empty()) return 1;
  for (const auto& [name, text] : madeMolecules(haemoglobin, protease)) {
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
