// Runs every target on its seeds and on 10 000 mutations with a fixed random seed, with any compiler.
//   test_fuzz                     all targets
//   test_fuzz pdb                 one
//   test_fuzz pdb 1234            only its run 1234, whose bytes are written to the file fuzz-pdb-1234
//   MOLTACT_FUZZ_RUNS, MOLTACT_FUZZ_SEED: the number of runs, and the random seed
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "tests/fuzz/changed.h"
#include "tests/fuzz/crash_note.h"
#include "tests/fuzz/target.h"

namespace {

using moltact::fuzz::changed;
using moltact::fuzz::fromEnvironment;
using moltact::fuzz::seedsOf;
using moltact::fuzz::Target;

constexpr unsigned kHang_s = 120;

}  // namespace

int main(int argc, char** argv) {
  moltact::fuzz::tellCrashes();
  const unsigned long runs = fromEnvironment("MOLTACT_FUZZ_RUNS", 10'000),
                      from = fromEnvironment("MOLTACT_FUZZ_SEED", 20'261'122);
  const bool one = argc > 2;
  const unsigned long wanted = one ? std::strtoul(argv[2], nullptr, 10) : 0;
  bool found = false;
  for (const Target& target : moltact::fuzz::targets()) {
    if (argc > 1 && std::strcmp(argv[1], target.name) != 0) continue;
    found = true;
    std::vector<std::string> seeds = seedsOf(target.name);
    if (seeds.empty()) {
      std::fprintf(stderr, "%s has no seeds\n", target.name);
      return 1;
    }
    const auto began = std::chrono::steady_clock::now();
    for (unsigned long k = one ? wanted : 0; k < (one ? wanted + 1 : runs); ++k) {
      moltact::fuzz::beginRun(std::string("test_fuzz ") + target.name + ' ' + std::to_string(k) +
                                  " (MOLTACT_FUZZ_SEED=" + std::to_string(from) + ')',
                              kHang_s);
      std::mt19937_64 random(from * 1'000'003 + k);
      const std::string bytes = k < seeds.size() ? seeds[k] : changed(seeds, random);
      if (one) std::ofstream(std::string("fuzz-") + target.name + '-' + argv[2], std::ios::binary) << bytes;
      target.run(bytes);
      moltact::fuzz::endRun();
    }
    std::printf("%-16s %lu runs from %lu, %.1f s\n", target.name, one ? 1 : runs, from,
                std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count());
    std::fflush(stdout);
  }
  if (!found) std::fprintf(stderr, "there is no target of that name\n");
  return found ? 0 : 1;
}
