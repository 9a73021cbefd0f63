// `moltact render` as a person calls it: exit status and the file that it leaves.
#include <doctest/doctest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "engine/render/picture.h"

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
  for (const char* wrong :
       {"--size 5x", "--size 99999x2", "--hip 1,2", "--hip nan,0,0", "--show conez", "--probe -1", "--method magic",
        "--zoom 0", "--label residues", "--label 'chain for chain Q'", "--mark orange", "--distance 'atom 1'",
        "--angle 'atom 1 - atom 2'", "--arrow '\"x\"'", "--hydrogen-bonds 'ligand XYZ'"}) {
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
