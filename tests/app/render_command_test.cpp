// `moltact render` as users call it: exit status and output file.
#include <doctest/doctest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>

#include "engine/render/picture.h"
#include "tests/app/scene_keys_in_help.h"

using namespace moltact;

namespace {

const std::string kMolecules = MOLTACT_SOURCE_DIR "/molecules/";
const std::filesystem::path kOut = std::filesystem::temp_directory_path() / "moltact-render-command.png";

int run(const std::string& arguments) {
  std::filesystem::remove(kOut);
  const std::string command = "'" MOLTACT_BINARY "' render " + arguments + " --out '" + kOut.string() + "' 2>/dev/null";
  return WEXITSTATUS(std::system(command.c_str()));
}

}  // namespace

TEST_CASE("render leaves a PNG of the size asked for, and a HIP pushed into benzene changes it") {
  REQUIRE(run("'" + kMolecules + "benzene.pdb' --size 200x120 --show atoms,haptic") == 0);
  const auto alone = readPng(kOut);
  REQUIRE(bool(alone));
  CHECK(alone->width_px == 200);
  CHECK(alone->height_px == 120);
  REQUIRE(run("'" + kMolecules + "benzene.pdb' --size 200x120 --show atoms,haptic --hip 0.4,0.3,1.2") == 0);
  const auto pushed = readPng(kOut);
  REQUIRE(bool(pushed));
  CHECK(pushed->rgb != alone->rgb);
  std::filesystem::remove(kOut);
}

TEST_CASE("render ends with 1 for a missing molecule and 2 for wrong usage, and leaves no file") {
  const std::string benzene = "'" + kMolecules + "benzene.pdb' ";
  CHECK(run("no-such-file.pdb") == 1);
  CHECK_FALSE(std::filesystem::exists(kOut));
  for (const char* wrong : {"--size 5x",
                            "--size 99999x2",
                            "--hip 1,2",
                            "--hip nan,0,0",
                            "--show conez",
                            "--probe -1",
                            "--method magic",
                            "--zoom 0",
                            "--label residues",
                            "--label 'chain for chain Q'",
                            "--mark orange",
                            "--distance 'atom 1'",
                            "--angle 'atom 1 - atom 2'",
                            "--arrow '\"x\"'",
                            "--hydrogen-bonds 'ligand XYZ'",
                            "--view tpo",
                            "--view 'facing residue 99'",
                            "--view front --azimuth 20",
                            "--highlight 'chain Q'",
                            "--state 40%",
                            "--captions 'a, b'",
                            "--then 'benzene, superposed on chain Q'",
                            "--then benzene --state ajar"}) {
    CAPTURE(wrong);
    CHECK(run(benzene + wrong) == 2);
    CHECK_FALSE(std::filesystem::exists(kOut));
  }
}

TEST_CASE(
    "each key of a scene that names, marks or measures is an option of render and changes the picture of benzene") {
  const std::string benzene = "'" + kMolecules + "benzene.pdb' --size 320x240 ";
  REQUIRE(run(benzene) == 0);
  const auto bare = readPng(kOut);
  REQUIRE(bool(bare));
  for (const char* option :
       {"--label 'atom for element C'", "--label '\"ring\" for element C'", "--arrow '\"one hydrogen\" for atom 6'",
        "--mark 'teal for atom 0'", "--distance 'atom 0 - atom 3'", "--angle 'atom 0 - atom 1 - atom 2'"}) {
    CAPTURE(option);
    REQUIRE(run(benzene + option) == 0);
    const auto with = readPng(kOut);
    REQUIRE(bool(with));
    CHECK(with->rgb != bare->rgb);
  }
  REQUIRE(run("'" + kMolecules + "1ubq.pdb' --size 320x240 --style cartoon") == 0);
  const auto alone = readPng(kOut);
  REQUIRE(run("'" + kMolecules + "1ubq.pdb' --size 320x240 --style cartoon --hydrogen-bonds backbone") == 0);
  const auto bonds = readPng(kOut);
  REQUIRE(bool(alone));
  REQUIRE(bool(bonds));
  CHECK(alone->rgb != bonds->rgb);
  std::filesystem::remove(kOut);
}

TEST_CASE("every key of a scene is an option of render, or has no meaning for a still picture") {
  // Why there is none.
  const std::map<std::string_view, const char*> without{{"molecule", "it is the argument"},
                                                        {"force", "a picture pushes nothing; --show has the arrow"},
                                                        {"panels", "there are none in the picture"},
                                                        {"paint", "nothing has been touched before"},
                                                        {"elastic", "a picture shows the molecule at rest"},
                                                        {"modes", "a picture shows the molecule at rest"},
                                                        {"view NAME", "a name is for links; --view takes what it says"},
                                                        {"frames", "a picture shows one frame, by --frame"},
                                                        {"speed", "it does not move"},
                                                        {"simulation", "a picture shows the molecule at rest"},
                                                        {"pull", "a picture pulls nothing"},
                                                        {"temperature", "a picture shows the molecule at rest"},
                                                        {"scan", "`moltact scan` writes what a tip sees"},
                                                        {"states", "names for the slider"},
                                                        {"locked", "nobody could change it"}};
  test::checkSceneKeysInHelp("render", without);
}

TEST_CASE("a view says what the camera's angles say: right is 90 degrees, top 90 degrees above, turned both") {
  const std::string benzene = "'" + kMolecules + "benzene.pdb' --size 200x160 ";
  const auto picture = [&](const std::string& options) {
    REQUIRE(run(benzene + options) == 0);
    const auto read = readPng(kOut);
    REQUIRE(bool(read));
    return read->rgb;
  };
  const auto front = picture("");
  CHECK(picture("--view front") == front);
  CHECK(picture("--view right") == picture("--azimuth 90"));
  CHECK(picture("--view top") == picture("--elevation 90"));
  CHECK(picture("--view 'turned 30 20'") == picture("--azimuth 30 --elevation 20"));
  CHECK(picture("--view 'front, zoom atom 0'") == picture("--zoom-to 'atom 0'"));
  CHECK(picture("--view 'facing atom 6'") != front);
}

TEST_CASE("highlight, magnify, a molecule beside, a second structure and the legend each change the picture") {
  const std::string argon = "'" + kMolecules + "argon-pair.pdb' --size 240x180 --show atoms,target ";
  const auto picture = [&](const std::string& options) {
    REQUIRE(run(argon + options) == 0);
    const auto read = readPng(kOut);
    REQUIRE(bool(read));
    return read->rgb;
  };
  const auto bare = picture("");
  for (const char* options : {"--highlight 'atom 0'", "--magnify 'atom 0'", "--beside benzene", "--legend"}) {
    CAPTURE(options);
    CHECK(picture(options) != bare);
  }
  CHECK(picture("--beside benzene") != picture("--beside benzene --captions 'one, other'"));
  const std::string enzyme = "'" + kMolecules + "4ake.pdb' --size 240x180 --style cartoon ";
  REQUIRE(run(enzyme) == 0);
  const auto open = readPng(kOut);
  REQUIRE(run(enzyme + "--then '1ake, superposed on residue 1-29 and chain A' --state 100%") == 0);
  const auto shut = readPng(kOut);
  REQUIRE(bool(open));
  REQUIRE(bool(shut));
  CHECK(open->rgb != shut->rgb);
  std::filesystem::remove(kOut);
}
