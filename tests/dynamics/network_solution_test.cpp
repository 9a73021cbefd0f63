// Modes and compliances that are kept on disk. Oracle: the computed ones, to the last bit.
#include "engine/dynamics/network_solution.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "engine/platform/temporary_folder.h"
#include "tests/dynamics/networks.h"

using namespace moltact;
using namespace moltact::test;

namespace {

namespace fs = std::filesystem;

struct KeptFolder {
  fs::path path = fs::temp_directory_path() / ("moltact-network-solution-" + std::to_string(::getpid()));
  KeptFolder() { fs::remove_all(path); }
  ~KeptFolder() { fs::remove_all(path); }
};

std::string contentOf(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void writeContent(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
}

bool sameSolution(const NetworkSolution& a, const NetworkSolution& b) {
  return a.modes.nodes == b.modes.nodes && a.modes.eigenvalues == b.modes.eigenvalues &&
         a.modes.vectors == b.modes.vectors && a.compliances == b.compliances;
}

// The number of calls of `progress`: 0 if nothing was computed.
struct Counted {
  int calls = 0;
  double last = -1.0;
  bool rising = true;
  std::function<bool(double)> progress() {
    return [this](double share) {
      rising = rising && share >= last && share >= 0.0 && share <= 1.0;
      last = share;
      ++calls;
      return true;
    };
  }
};

}  // namespace

TEST_CASE("the 20 modes and 76 compliances of ubiquitin come from the cache to the last bit, without being computed") {
  const KeptFolder kept;
  const ElasticNetwork network = networkOf(libraryMolecule("1ubq.pdb"));
  Counted first, second;
  const auto computed = keptOrSolved(network, 20, kept.path, first.progress());
  REQUIRE(bool(computed));
  CHECK(first.calls == 76);
  CHECK(first.rising);
  CHECK(first.last > 0.95);
  CHECK(computed->modes.count() == 20);
  CHECK(fs::file_size(solutionFile(kept.path, network, 20)) == 32 + 8 * (20 + 3 * 20 * 76 + 9 * 76) + 8);
  const auto again = keptOrSolved(network, 20, kept.path, second.progress());
  REQUIRE(bool(again));
  CHECK(second.calls == 0);
  CHECK(sameSolution(*computed, *again));
}

TEST_CASE("a cache file that is cut at any byte, or has any one byte changed, or a byte more, is no solution") {
  const ElasticNetwork network = networkOf(beads({{5, 5, 5}, {5, -5, -5}, {-5, 5, -5}, {-5, -5, 5}}));
  const auto computed = solved(network, 6);
  REQUIRE(bool(computed));
  const std::string good = bytesOf(*computed, network, 6);
  REQUIRE(solutionIn(good, network, 6));
  for (std::size_t k = 0; k < good.size(); ++k) {
    CAPTURE(k);
    CHECK_FALSE(solutionIn(good.substr(0, k), network, 6));
    std::string changed = good;
    changed[k] = char(changed[k] ^ 0x20);
    CHECK_FALSE(solutionIn(changed, network, 6));
  }
  CHECK_FALSE(solutionIn(good + '\0', network, 6));
}

TEST_CASE("a solution of another network, of another number of modes, or with a NaN is none") {
  const ElasticNetwork network = networkOf(beads({{5, 5, 5}, {5, -5, -5}, {-5, 5, -5}, {-5, -5, 5}}));
  const ElasticNetwork moved = networkOf(beads({{5, 5, 5}, {5, -5, -5}, {-5, 5, -5}, {-5, -5, 5.001}}));
  const ElasticNetwork fewer = networkOf(beads({{5, 5, 5}, {5, -5, -5}, {-5, 5, -5}, {-5, -5, 5}}), 14.2);
  REQUIRE(fewer.springs().size() == network.springs().size());
  auto computed = solved(network, 6);
  REQUIRE(bool(computed));
  CHECK_FALSE(solutionIn(bytesOf(*computed, network, 6), moved, 6));
  CHECK_FALSE(solutionIn(bytesOf(*computed, network, 6), network, 5));
  // The same springs of another cut-off have the same modes.
  CHECK(solutionIn(bytesOf(*computed, network, 6), fewer, 6));
  computed->compliances[2][1][0] = std::nan("");
  CHECK_FALSE(solutionIn(bytesOf(*computed, network, 6), network, 6));
}

TEST_CASE("a damaged cache file is computed anew and replaced; of 101 files the oldest goes; no folder is no problem") {
  const KeptFolder kept;
  const ElasticNetwork network = networkOf(libraryMolecule("1ubq.pdb"));
  const auto computed = keptOrSolved(network, 3, kept.path);
  REQUIRE(bool(computed));
  const fs::path file = solutionFile(kept.path, network, 3);
  const std::string good = contentOf(file);
  for (const std::string& bad : {std::string(), good.substr(0, good.size() / 2), std::string(10 << 20, 'x')}) {
    writeContent(file, bad);
    Counted counted;
    const auto anew = keptOrSolved(network, 3, kept.path, counted.progress());
    REQUIRE(bool(anew));
    CHECK(counted.calls == 76);
    CHECK(sameSolution(*anew, *computed));
    CHECK(contentOf(file) == good);
  }
  fs::remove(file);
  for (std::size_t k = 0; k < kMaxKeptSolutions; ++k) {
    const fs::path other = kept.path / ("network-" + std::to_string(k) + ".modes");
    writeContent(other, "x");
    fs::last_write_time(other, fs::file_time_type::clock::now() - std::chrono::hours(2 + (k == 7 ? 1 : 0)));
  }
  REQUIRE(bool(keptOrSolved(network, 3, kept.path)));
  CHECK(fs::exists(file));
  CHECK_FALSE(fs::exists(kept.path / "network-7.modes"));
  CHECK(std::distance(fs::directory_iterator(kept.path), {}) == std::ptrdiff_t(kMaxKeptSolutions));
  const fs::path no_folder = file / "below";  // below a file
  CHECK(bool(keptOrSolved(network, 3, no_folder)));
  const auto cancelled = keptOrSolved(network, 4, kept.path, [](double) { return false; });
  REQUIRE_FALSE(bool(cancelled));
  CHECK(cancelled.problem().message == "the calculation was cancelled");
  CHECK_FALSE(fs::exists(solutionFile(kept.path, network, 4)));
}
