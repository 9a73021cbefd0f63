// The commands that take a trajectory: `moltact info` and `moltact render --trajectory`.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "engine/render/picture.h"
#include "tests/app/command_place.h"

using namespace moltact;
using namespace moltact::test;

namespace {

bool says(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

// Two carbons at rest and an oxygen that each of four models moves on by 3 A, then one that stands.
void writeFour(const CommandPlace& place) {
  std::ofstream file(place.folder / "four.pdb");
  for (int model = 0; model < 4; ++model) {
    char oxygen[96];
    std::snprintf(oxygen, sizeof oxygen, "HETATM    3  O3  LIG A   1    %8.3f%8.3f%8.3f  1.00  0.00           O\n", 0.0,
                  3.0 + 3.0 * model, 0.0);
    file << "MODEL        " << model + 1 << "\n"
         << "HETATM    1  C1  LIG A   1       0.000   0.000   0.000  1.00  0.00           C\n"
         << "HETATM    2  C2  LIG A   1       1.500   0.000   0.000  1.00  0.00           C\n"
         << oxygen << "ENDMDL\n";
  }
  file << "END\n";
}

}  // namespace

TEST_CASE(
    "info of an XTC file states its 300 atoms, 3 frames, 0 to 10 ps and the cell's edge of 25 A, in words and as "
    "JSON") {
  const CommandPlace place;
  const std::string file = "'" MOLTACT_SOURCE_DIR "/tests/trajectory/data/waters.xtc'";
  const Run run = place.run("info " + file);
  REQUIRE_MESSAGE(run.status == 0, run.err);
  for (const char* line : {"format    XTC", "atoms     300", "frames    3", "time      0.000 ps to 10.000 ps", "25.0"})
    CHECK_MESSAGE(says(run.out, line), run.out);
  const auto json = nlohmann::json::parse(place.run("info --json " + file).out);
  CHECK(json.at("atoms") == 300);
  CHECK(json.at("frames") == 3);
  CHECK(json.at("time_ps") == nlohmann::json({0.0, 10.0}));
  CHECK(json.at("cell_edges_A")[1].get<double>() == doctest::Approx(25.0).epsilon(1e-6));
  CHECK(json.at("warnings").empty());
}

TEST_CASE(
    "render draws the frame that --frame counts from 1: the first looks like the molecule, each of four otherwise; a "
    "fifth is an error that names their number") {
  const CommandPlace place;
  writeFour(place);
  const auto drawn = [&](const std::string& more) {
    const Run run = place.run("render four.pdb --size 96x96 --out x.png --hip 0,0,40 " + more);
    CHECK_MESSAGE(run.status == 0, run.err);
    const auto picture = readPng(place.folder / "x.png");
    REQUIRE(bool(picture));
    return picture->rgb;
  };
  const std::string trajectory = "--trajectory 'four.pdb, not superposed' ";
  const auto still = drawn("");
  std::vector<std::vector<std::uint8_t>> frames;
  for (int frame = 1; frame <= 4; ++frame) {
    const auto rgb = drawn(trajectory + "--frame " + std::to_string(frame));
    frames.emplace_back(rgb.begin(), rgb.end());
  }
  CHECK(frames[0] == std::vector<std::uint8_t>(still.begin(), still.end()));
  for (std::size_t a = 0; a < 4; ++a)
    for (std::size_t b = 0; b < a; ++b) CHECK(frames[a] != frames[b]);
  // Atom 3 is the one that fluctuates; without a trajectory nothing does.
  CHECK(drawn(trajectory + "--colour fluctuation") != drawn(trajectory + "--colour element"));
  const Run fifth = place.run("render four.pdb --out x.png " + trajectory + "--frame 5");
  CHECK(fifth.status == 2);
  CHECK_MESSAGE(says(fifth.err, "--frame: the trajectory has 4 frames"), fifth.err);
  const Run none = place.run("render four.pdb --out x.png --trajectory missing.xtc");
  CHECK(none.status == 1);
  CHECK_MESSAGE(says(none.err, "missing.xtc"), none.err);
}
