// moltact_energy_ticks MOLECULES: times the methods of pageEnergyMethods() on the three bodies of the chart of energies, as
// WebAssembly under Node.js. Prints pageTickLines(). MOLECULES is the folder
// with 1hpv.pdb and 2hhb.pdb.
#include <cstdio>

#include "engine/bench/energies/page_ticks.h"
#include "engine/molecule/reader.h"

int main(int argc, char** argv) {
  using namespace moltact;
  if (argc != 2) return 2;
  const std::string folder = argv[1];
  bench::EnergyTradeOffOptions options;
  options.methods = bench::pageEnergyMethods();
  options.judged_pairs = 0;  // accuracy is that of the desktop program
  const auto points = bench::measureEnergies(
      options, [&](const std::string& id) { return readMolecule(folder + "/" + id + ".pdb"); }, {});
  if (!points) {
    std::fprintf(stderr, "%s\n", points.problem().text().c_str());
    return 1;
  }
  std::fputs(bench::pageTickLines(*points).c_str(), stdout);
  return 0;
}
