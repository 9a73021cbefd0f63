// `moltact grid` as users call it: exit status, files and their energies.
#include <doctest/doctest.h>
#include <sys/wait.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "engine/structure/map_file.h"

using namespace moltact;

namespace {

namespace fs = std::filesystem;

const fs::path kGridFolder = fs::temp_directory_path() / "moltact-grid-command";

int runGridCommand(const std::string& arguments) {
  fs::remove_all(kGridFolder);
  fs::create_directories(kGridFolder);
  return WEXITSTATUS(std::system(("'" MOLTACT_BINARY "' grid " + arguments + " >/dev/null 2>&1").c_str()));
}

}  // namespace

TEST_CASE(
    "grid writes seven maps of one box and their list; the carbon map lies in its well above benzene's ring and in a "
    "wall at an atom; --like repeats the box") {
  const std::string stem = (kGridFolder / "b").string(), out = " --out '" + stem + "'";
  REQUIRE(runGridCommand("benzene --spacing 0.5" + out) == 0);
  GridBox box;
  for (const char* name : {"C", "A", "N", "OA", "SA", "HD", "e"}) {
    const auto map = readMapFile(stem + "." + name + ".map");
    REQUIRE(map);
    if (box.nodes[0] == 0) box = map->box;
    CHECK(map->box == box);
  }
  CHECK(fs::exists(stem + ".maps.fld"));
  CHECK(fs::exists(stem + ".maps.xyz"));
  const auto carbon = readMapFile(stem + ".C.map");
  float low = 0, high = 0;
  for (const float value : carbon->values) low = std::min(low, value), high = std::max(high, value);
  CHECK(low < -0.4f);  // six carbons at once, about 0.1 kcal/mol each
  CHECK(low > -1.2f);
  CHECK(high > 1e3f);
  const fs::path kept = fs::temp_directory_path() / "moltact-grid-command.map";
  fs::copy_file(stem + ".C.map", kept, fs::copy_options::overwrite_existing);
  REQUIRE(runGridCommand("benzene --like '" + kept.string() + "'" + out) == 0);
  const auto again = readMapFile(stem + ".C.map");
  REQUIRE(again);
  CHECK(again->box == box);
  CHECK(again->values == carbon->values);
}

TEST_CASE(
    "grid --compare finds a correlation of 1 with its own maps and the factor of a map that is a third as large; a "
    "file "
    "without a type and one of another box give status 1, and nothing is written") {
  const fs::path kept = fs::temp_directory_path() / "moltact-grid-compare";
  fs::remove_all(kept);
  fs::create_directories(kept);
  REQUIRE(runGridCommand("benzene --spacing 0.5 --out '" + (kept / "b").string() + "'") == 0);
  const auto oxygen = readMapFile(kept / "b.OA.map");
  REQUIRE(oxygen);
  std::vector<float> third = oxygen->values;
  for (float& value : third) value /= 3.0f;
  std::ofstream(kept / "third.OA.map") << mapText(oxygen->box, third, "third", "benzene");
  fs::copy_file(kept / "b.OA.map", kept / "plain.map");
  const auto compare = [&](const std::string& files) {
    const std::string command = "cd '" + kept.string() + "' && '" MOLTACT_BINARY "' grid benzene --compare " + files +
                                " > '" + (kept / "answer").string() + "' 2>&1";
    const int status = WEXITSTATUS(std::system(command.c_str()));
    std::ifstream answer(kept / "answer");
    return std::pair(status, std::string(std::istreambuf_iterator<char>(answer), {}));
  };
  const auto [status, said] = compare("b.C.map b.e.map third.OA.map");
  CHECK(status == 0);
  INFO(said);
  CHECK(said.find("b.C.map: ") == 0);
  CHECK(said.find("b.e.map: ") != std::string::npos);
  const std::string last = said.substr(said.find("third.OA.map"));
  CHECK(last.find("correlation 1.0000, factor 0.3333, rms difference") != std::string::npos);
  CHECK(said.find("correlation 1.0000, factor 1.0000") < said.find("b.e.map"));
  CHECK(compare("plain.map").first == 1);
  CHECK(compare("plain.map").second.find(".OA.map") != std::string::npos);
  REQUIRE(runGridCommand("benzene --spacing 0.4 --out '" + (kept / "other").string() + "'") == 0);
  const auto [unlike, problem] = compare("b.C.map other.C.map");
  CHECK(unlike == 1);
  CHECK(problem.find("other.C.map: the box differs from that of b.C.map") != std::string::npos);
  CHECK(fs::is_empty(kGridFolder));
  fs::remove_all(kept);
}

TEST_CASE("grid without a file, with a wrong option, a box of 10 GB or all atoms taken gives a status and no map") {
  const std::string out = " --out '" + (kGridFolder / "b").string() + "'";
  CHECK(runGridCommand("benzene") != 0);
  CHECK(runGridCommand("no-such-molecule" + out) == 1);
  CHECK(runGridCommand("benzene --box 0 0 0 500 500 500" + out) == 1);
  CHECK(runGridCommand("benzene --like /no/such.map" + out) == 1);
  for (const std::string wrong : {"--spacing 0", "--spacing x", "--box 0 0 0", "--box 0 0 0 -1 1 1", "--around wax",
                                  "--around all", "--margin -1", "--dielectric oil"}) {
    CAPTURE(wrong);
    CHECK(runGridCommand("benzene" + out + " " + wrong) == 2);
  }
  CHECK(fs::is_empty(kGridFolder));
}
