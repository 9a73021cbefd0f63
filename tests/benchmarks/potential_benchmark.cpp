// The time of the colouring `potential`: the charges and the sorting of the atoms, and the pieces, for copies of
// haemoglobin side by side. Times of the processor on one thread, the minimum of three runs; the window shares the pieces
// among all processors. Run: build/release/potential_benchmark
#include <algorithm>
#include <cstdio>
#include <ctime>

#include "engine/haptics/field/force_choices.h"
#include "engine/molecule/reader.h"
#include "engine/molecule/side_by_side.h"
#include "engine/structure/surface_potential.h"

namespace {

using namespace moltact;

double now_ms() { return 1e3 * double(std::clock()) / double(CLOCKS_PER_SEC); }

}  // namespace

int main() {
  const auto one = readMolecule(MOLTACT_SOURCE_DIR "/molecules/2hhb.pdb");
  if (!one) {
    std::fprintf(stderr, "%s\n", one.problem().text().c_str());
    return 2;
  }
  std::printf(
      "| atoms | charges, sorting (ms) | pieces | all pieces (ms) | the longest piece (ms) |\n"
      "| ---: | ---: | ---: | ---: | ---: |\n");
  for (const std::size_t wanted : {std::size_t(1), std::size_t(13'000), std::size_t(100'000)}) {
    Molecule many = *one;
    while (many.atoms.size() < wanted) {
      const std::size_t missing = wanted - many.atoms.size();
      many = sideBySide(many, missing >= many.atoms.size() ? many : *one);
    }
    double prepared_ms = 1e9, pieces_ms = 1e9, longest_ms = 1e9;
    std::size_t pieces = 0;
    for (int run = 0; run < 3; ++run) {
      const double begun = now_ms();
      SurfacePotential work(many, dielectricChoice("water"));
      const double prepared = now_ms();
      pieces = work.pieces();
      double longest = 0.0;
      for (std::size_t piece = 0; piece < pieces; ++piece) {
        const double from = now_ms();
        work.compute(piece);
        longest = std::max(longest, now_ms() - from);
      }
      prepared_ms = std::min(prepared_ms, prepared - begun);
      pieces_ms = std::min(pieces_ms, now_ms() - prepared);
      longest_ms = std::min(longest_ms, longest);
    }
    std::printf("| %zu | %.0f | %zu | %.0f | %.1f |\n", many.atoms.size(), prepared_ms, pieces, pieces_ms, longest_ms);
    std::fflush(stdout);
  }
}
