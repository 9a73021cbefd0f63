// `moltact export` as a person calls it: exit status and the file that it leaves.
#include <doctest/doctest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "engine/gltf/gltf_file.h"

using namespace moltact;

namespace {

const std::filesystem::path kOut = std::filesystem::temp_directory_path() / "moltact-export-command.glb";

int run(const std::string& arguments) {
  std::filesystem::remove(kOut);
  return WEXITSTATUS(std::system(("'" MOLTACT_BINARY "' export " + arguments + " >/dev/null 2>&1").c_str()));
}

}  // namespace

TEST_CASE(
    "export leaves benzene as 12 balls or as a surface, which read back; wrong usage gives 2, a missing molecule 1, "
    "and no file") {
  const std::string out = " '" + kOut.string() + "'";
  REQUIRE(run("benzene" + out) == 0);
  const auto balls = readGltf(kOut);
  REQUIRE(bool(balls));
  CHECK(balls->corners.size() == 12 * 3 * 1280);
  REQUIRE(run("benzene" + out + " --print --probe 1.4 --step 0.3") == 0);
  const auto surface = readGltf(kOut);
  REQUIRE(bool(surface));
  CHECK(surface->corners.size() > 3000);
  REQUIRE(run("alpha-helix" + out + " --style 'cartoon, spheres for residue 1' --colour chain") == 0);
  CHECK(bool(readGltf(kOut)));
  for (const std::string wrong : {"--style wax", "--probe -1", "--step x", "--units-per-nm 0"}) {
    CAPTURE(wrong);
    CHECK(run("benzene" + out + " " + wrong) == 2);
    CHECK_FALSE(std::filesystem::exists(kOut));
  }
  CHECK(run("benzene benzene.obj") == 2);
  CHECK(run("no-such-molecule" + out) == 1);
  CHECK(run("1ubq --print --step 0.01" + out) == 1);
  CHECK_FALSE(std::filesystem::exists(kOut));
}
