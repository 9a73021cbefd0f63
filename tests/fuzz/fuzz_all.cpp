// Every target on its seeds and on 10 000 changed ones, from a fixed number, with any compiler.
//   test_fuzz                     all targets
//   test_fuzz pdb                 one
//   test_fuzz pdb 1234            its run 1234 alone, whose bytes go to the file fuzz-pdb-1234
//   MOLTACT_FUZZ_RUNS, MOLTACT_FUZZ_SEED: how many runs, and from which number
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <vector>

#include "tests/fuzz/target.h"

namespace {

namespace fs = std::filesystem;
using moltact::fuzz::Target;

constexpr unsigned kHang_s = 120;  // a run that takes so long does not end
constexpr std::size_t kLongest = 4096;

char now[128];  // what is being done, for who comes to know of a crash

extern "C" void tell(int number) {
  const char* what = number == SIGALRM ? " does not end\n" : " ended the program\n";
  if (::write(2, now, std::strlen(now)) < 0 || ::write(2, what, std::strlen(what)) < 0) ::_exit(2);
  ::signal(number, SIG_DFL);
  ::raise(number);
}

std::vector<std::string> seedsOf(const Target& target) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator it(fs::path(MOLTACT_SOURCE_DIR) / "tests/fuzz/seeds" / target.name, error), end;
       !error && it != end; it.increment(error))
    files.push_back(it->path());
  std::sort(files.begin(), files.end());
  std::vector<std::string> out;
  for (const fs::path& file : files) {
    std::ifstream in(file, std::ios::binary);
    out.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
  }
  return out;
}

// One of the seeds with 1 to 8 changes: bits, bytes, signs, ranges that go, come twice or come from another seed.
std::string changed(const std::vector<std::string>& seeds, std::mt19937_64& random) {
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % std::max<std::size_t>(n, 1)); };
  std::string out = seeds[below(seeds.size())];
  constexpr std::string_view kSigns = "0123456789 -+.eE\n\r\t'\"(),_#;:[]{}<>!`~*|\\/=%&?$";
  constexpr std::string_view kWords[] = {"nan",         "inf",   "-1",   "1e309",        "1e38",     "2147483648",
                                         "99999999999", "0x",    "\xff", "\xef\xbb\xbf", "\xe2\x82", "\n\n",
                                         "```",         "---\n", "\"\"", "null"};
  for (std::size_t n = 1 + below(8); n > 0; --n) {
    const std::size_t at = below(out.size() + 1);
    switch (below(9)) {
      case 0:
        if (at < out.size()) out[at] ^= char(1 << below(8));
        break;
      case 1:
        if (at < out.size()) out[at] = char(random());
        break;
      case 2:
        if (at < out.size()) out[at] = kSigns[below(kSigns.size())];
        break;
      case 3:
        out.insert(at, 1, kSigns[below(kSigns.size())]);
        break;
      case 4:
        out.insert(at, kWords[below(std::size(kWords))]);
        break;
      case 5:
        out.erase(at, below(2) ? below(8) : below(out.size() / 4 + 1));
        break;
      case 6:
        out.insert(at, out.substr(below(out.size()), below(200)));
        break;
      case 7: {
        const std::string& other = seeds[below(seeds.size())];
        out.insert(at, other.substr(below(other.size()), below(400)));
        break;
      }
      default:
        if (below(8) == 0) out.resize(at);
        break;
    }
  }
  if (out.size() > kLongest) out.resize(kLongest);
  return out;
}

unsigned long number(const char* name, unsigned long otherwise) {
  const char* text = std::getenv(name);
  return text ? std::strtoul(text, nullptr, 10) : otherwise;
}

}  // namespace

int main(int argc, char** argv) {
  for (const int s : {SIGABRT, SIGSEGV, SIGFPE, SIGBUS, SIGILL, SIGALRM}) ::signal(s, tell);
  const unsigned long runs = number("MOLTACT_FUZZ_RUNS", 10'000), from = number("MOLTACT_FUZZ_SEED", 20'261'122);
  const bool one = argc > 2;
  const unsigned long wanted = one ? std::strtoul(argv[2], nullptr, 10) : 0;
  bool found = false;
  for (const Target& target : moltact::fuzz::targets()) {
    if (argc > 1 && std::strcmp(argv[1], target.name) != 0) continue;
    found = true;
    std::vector<std::string> seeds = seedsOf(target);
    if (seeds.empty()) {
      std::fprintf(stderr, "%s has no seeds\n", target.name);
      return 1;
    }
    const auto began = std::chrono::steady_clock::now();
    for (unsigned long k = one ? wanted : 0; k < (one ? wanted + 1 : runs); ++k) {
      std::snprintf(now, sizeof now, "test_fuzz %s %lu (MOLTACT_FUZZ_SEED=%lu)", target.name, k, from);
      std::mt19937_64 random(from * 1'000'003 + k);
      const std::string bytes = k < seeds.size() ? seeds[k] : changed(seeds, random);
      if (one) std::ofstream(std::string("fuzz-") + target.name + '-' + argv[2], std::ios::binary) << bytes;
      ::alarm(kHang_s);
      target.run(bytes);
      ::alarm(0);
    }
    std::printf("%-16s %lu runs from %lu, %.1f s\n", target.name, one ? 1 : runs, from,
                std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count());
    std::fflush(stdout);
  }
  if (!found) std::fprintf(stderr, "there is no target of that name\n");
  return found ? 0 : 1;
}
