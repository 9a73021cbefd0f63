// moltact_energy_ticks: times the methods of pageEnergyMethods() on the three bodies of the chart of energies, as
// WebAssembly under Node.js. Prints pageTickLines().
#include <cstdio>

#include "engine/bench/energies/page_ticks.h"
#include "engine/molecule/catalogue.h"

int main() {
  using namespace moltact;
  bench::EnergyTradeOffOptions options;
  options.methods = bench::pageEnergyMethods();
  options.judged_pairs = 0;  // accuracy is that of the desktop program
  const auto points = bench::measureEnergies(options, [](const std::string& id) { return openMolecule(id); }, {});
  if (!points) {
    std::fprintf(stderr, "%s\n", points.problem().text().c_str());
    return 1;
  }
  std::fputs(bench::pageTickLines(*points).c_str(), stdout);
  return 0;
}
