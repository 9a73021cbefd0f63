// The commands that feel a molecule with a body in the hand: `moltact render`, `replay` and `bench bodies`. Good output, and
// for each invalid input a message with its place and its remedy.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "engine/render/picture.h"
#include "tests/app/command_place.h"

using namespace moltact;
using namespace moltact::test;

namespace {

bool says(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

// Three spheres: atoms 1 and 2, 3 A apart along x at z = 9, are held; atom 0 lies below the second.
void writeThree(const CommandPlace& place) {
  std::ofstream(place.folder / "three.xyzr") << "1.5 0 0 2.0\n-1.5 0 9 1.5\n1.5 0 9 1.5\n";
}

}  // namespace

TEST_CASE("render draws a held body turned by 90 degrees otherwise than unturned, with springs as well") {
  const CommandPlace place;
  writeThree(place);
  const auto drawn = [&](const std::string& more) {
    const Run run =
        place.run("render three.xyzr --size 96x96 --in-hand 'atom 1 or atom 2' --hip 0,0,4 --out x.png " + more);
    CHECK_MESSAGE(run.status == 0, run.err);
    const auto picture = readPng(place.folder / "x.png");
    REQUIRE(bool(picture));
    CHECK(picture->width_px == 96);
    return picture->rgb;
  };
  const auto unturned = drawn("");
  CHECK(drawn("--orientation 1,0,0,0") == unturned);
  CHECK(drawn("--orientation 0.7071068,0,0.7071068,0") != unturned);
  CHECK(drawn("--hand springs --orientation 0.7071068,0,0.7071068,0") != drawn("--hand springs"));
}

TEST_CASE("render rejects a body's hand without a body, orientations that are none, and atoms that are not there") {
  const CommandPlace place;
  writeThree(place);
  const struct {
    const char* options;
    int status;
    const char* says;
    const char* remedy;
  } wrong[] = {{"--hand springs", 1, "--hand: the hand holds no body, which 'springs' needs", "--in-hand"},
               {"--orientation 1,0,0,0", 2, "--orientation: there is nothing in the hand to turn", "add --in-hand"},
               {"--in-hand 'atom 1' --orientation 1,2", 2, "--orientation: '1,2' is not a quaternion", "write w,x,y,z"},
               {"--in-hand 'atom 1' --orientation 2,0,0,0", 2, "'2,0,0,0' is not a quaternion", "write w,x,y,z"},
               {"--in-hand 'ligan'", 2, "--in-hand: 'ligan' is no word of a selection", "did you mean 'ligand'?"},
               {"--in-hand 'atom 9'", 2, "--in-hand: ", ""},
               {"--in-hand 'atom 1' --hand probe", 1, "--hand: the hand holds a body, which 'probe' does not feel",
                "leave out --hand for 'exact-body', or write the name of another interaction with a body"},
               {"--in-hand 'atom 1' --hand rope", 2, "--hand: rope not in {probe,exact-body,springs}", "--help"}};
  for (const auto& w : wrong) {
    CAPTURE(w.options);
    const Run run = place.run("render three.xyzr --size 96x96 --out x.png " + std::string(w.options));
    CAPTURE(run.err);
    CHECK(run.status == w.status);
    CHECK(says(run.err, w.says));
    CHECK(says(run.err, w.remedy));
    CHECK_FALSE(std::filesystem::exists(place.folder / "x.png"));
  }
}

TEST_CASE(
    "replay with --hand springs keeps the hand's orientation and is at rest in each tick; without a body it is "
    "refused") {
  const CommandPlace place;
  writeThree(place);
  std::ofstream(place.folder / "pose.csv") << "x,y,z,qw,qx,qy,qz\n0,0,9,1,0,0,0\n0,0,2.6,0.8,0,0,0.6\n";
  const Run run =
      place.run("replay three.xyzr --in-hand 'atom 1 or atom 2' --hand springs --path pose.csv --out out.csv");
  REQUIRE_MESSAGE(run.status == 0, run.err);
  std::ifstream out(place.folder / "out.csv");
  std::string head, first, second;
  std::getline(out, head);
  std::getline(out, first);
  std::getline(out, second);
  CHECK(head.starts_with("hand_x,hand_y,hand_z,hand_qw"));
  CHECK(first.ends_with(",1"));
  CHECK(second.ends_with(",1"));
  std::vector<std::string> row;
  std::istringstream columns(second);
  for (std::string column; std::getline(columns, column, ',');) row.push_back(column);
  REQUIRE(row.size() == 21);
  CHECK(std::stod(row[3]) == doctest::Approx(0.8));
  for (std::size_t k = 3; k < 7; ++k) CHECK(row[k] == row[k + 7]);
  const Run bare = place.run("replay three.xyzr --hand springs --path pose.csv --time");
  CHECK(bare.status == 1);
  CHECK(
      says(bare.err, "--hand: the hand holds no body, which 'springs' needs; name what the hand holds with --in-hand"));
}

TEST_CASE("replay rejects --hand probe for a body; without --hand the body is an exact-body") {
  const CommandPlace place;
  writeThree(place);
  std::ofstream(place.folder / "pose.csv") << "x,y,z,qw,qx,qy,qz\n0,0,9,1,0,0,0\n0,0,2.6,0.8,0,0,0.6\n";
  const std::string command = "replay three.xyzr --in-hand 'atom 1 or atom 2' --path pose.csv --out ";
  const Run probe = place.run(command + "out.csv --hand probe");
  CHECK(probe.status == 1);
  CHECK(
      says(probe.err, "--hand: the hand holds a body, which 'probe' does not feel; leave out --hand for 'exact-body'"));
  CHECK_FALSE(std::filesystem::exists(place.folder / "out.csv"));
  CHECK(place.run(command + "bare.csv").status == 0);
  CHECK(place.run(command + "named.csv --hand exact-body").status == 0);
  CHECK(contents(place.folder / "bare.csv").size() > 100);
  CHECK(contents(place.folder / "bare.csv") == contents(place.folder / "named.csv"));
}

TEST_CASE("bench bodies rejects an unknown method, recorded hands that it does not use, and an unwritable folder") {
  const CommandPlace place;
  const Run method = place.run("bench bodies --quick --methods nope");
  CHECK(method.status == 1);
  CHECK(says(method.err, "--methods: there is no method \"nope\"; choose from exact, "));
  CHECK(says(method.err, "exact-body, springs, point-penalty"));
  const Run hands = place.run("bench bodies --quick --recording x.recording");
  CHECK(hands.status == 1);
  CHECK(
      says(hands.err, "--recording: the part bodies uses no recorded hands; leave it out, or measure the part hands"));
  std::ofstream(place.folder / "file") << "x";
  const Run folder = place.run("bench bodies --quick --csv file/in");
  CHECK(folder.status == 1);
  CHECK(says(folder.err, "file/in"));
}
