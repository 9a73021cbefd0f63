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
  for (const char* wrong : {"--size 5x", "--size 99999x2", "--hip 1,2", "--hip nan,0,0", "--show conez", "--probe -1",
                            "--method magic", "--zoom 0"}) {
    CAPTURE(wrong);
    CHECK(run(benzene + wrong) == 2);
    CHECK_FALSE(std::filesystem::exists(kOut));
  }
}
