// `moltact export` as users call it: exit status and output file.
#include <doctest/doctest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>

#include "engine/gltf/gltf_file.h"
#include "tests/app/scene_keys_in_help.h"

using namespace moltact;

namespace {

const std::filesystem::path kOut = std::filesystem::temp_directory_path() / "moltact-export-command.glb";

int run(const std::string& arguments) {
  std::filesystem::remove(kOut);
  return WEXITSTATUS(std::system(("'" MOLTACT_BINARY "' export " + arguments + " >/dev/null 2>&1").c_str()));
}

}  // namespace

TEST_CASE(
    "export leaves benzene as 12 spheres or as a surface, which read back; wrong usage gives 2, a missing molecule 1, "
    "and no file") {
  const std::string out = " '" + kOut.string() + "'";
  REQUIRE(run("benzene" + out) == 0);
  const auto spheres = readGltf(kOut);
  REQUIRE(bool(spheres));
  CHECK(spheres->corners.size() == 12 * 3 * 1280);
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

TEST_CASE(
    "what a scene marks, measures and moves is in an exported model too: benzene marked has two colours more, a "
    "distance of 2.8 A six dashes more, and a second state other places") {
  const std::string out = " '" + kOut.string() + "'";
  const auto exported = [&](const std::string& arguments) {
    REQUIRE(run(arguments + out) == 0);
    auto model = readGltf(kOut);
    REQUIRE(bool(model));
    return *std::move(model);
  };
  const auto coloured = [](const SolidModel& model, glm::vec3 colour) {
    return std::count_if(model.corners.begin(), model.corners.end(),
                         [&](const SolidModel::Corner& c) { return glm::distance(c.colour, colour) < 0.01f; });
  };
  const SolidModel bare = exported("benzene");
  const SolidModel marked = exported("benzene --mark 'red for atom 0' --highlight 'atom 1'");
  CHECK(marked.corners.size() == bare.corners.size());
  const glm::vec3 target(1.0f, 90.0f / 255.0f, 0.0f);
  CHECK(coloured(bare, target) == 0);
  CHECK(coloured(marked, target) == 3 * 1280);
  CHECK(exported("benzene --distance 'atom 0 - atom 3'").corners.size() > bare.corners.size() + 6 * 3 * 10);
  CHECK(exported("benzene --angle 'atom 0 - atom 1 - atom 2'").corners.size() > bare.corners.size() + 6 * 3 * 10);
  const std::size_t without = exported("alpha-helix --style cartoon").corners.size();
  CHECK(exported("alpha-helix --style cartoon --hydrogen-bonds backbone").corners.size() > without + 1000);
  // The lid turns: it is as wide as before in another direction.
  const std::string lid = "4ake --style cartoon --hide 'not (chain A and residue 122-159)' --then 1ake --state ";
  const SolidModel first = exported(lid + "0%"), second = exported(lid + "100%");
  CHECK(first.corners.size() == second.corners.size());
  CHECK(glm::distance(first.high - first.low, second.high - second.low) > 0.2f);
  const SolidModel two = exported("benzene --beside water");
  CHECK(two.corners.size() == bare.corners.size() + 3 * 3 * 1280);
  for (const std::string wrong : {"--mark orange", "--state 40%", "--then benzene --state ajar", "--distance 'atom 1'",
                                  "--hydrogen-bonds 'ligand XYZ'", "--highlight 'chain Q'"}) {
    CAPTURE(wrong);
    CHECK(run("benzene" + out + " " + wrong) == 2);
    CHECK_FALSE(std::filesystem::exists(kOut));
  }
}

TEST_CASE("every key of a scene is an option of export, or has no meaning for a model that is turned by hand") {
  // Why there is none.
  const std::map<std::string_view, const char*> without{
      {"molecule", "it is the argument"},
      {"method", "a model is not felt"},
      {"force", "a model is not felt"},
      {"charges", "a model is not felt"},
      {"forces", "a model is not felt"},
      {"dielectric", "a model is not felt"},
      {"probe-charge", "a model is not felt"},
      {"coupling", "a model is not felt"},
      {"weak-gain", "a model is not felt"},
      {"scan", "`moltact scan` writes what a tip sees"},
      {"stiffness", "a model is not felt"},
      {"friction", "a model is not felt"},
      {"stick-slip", "a model is not felt"},
      {"texture", "a model is not felt"},
      {"show", "the probe, its force and the haptic surface are of the hand"},
      {"near", "there is no probe in it"},
      {"in-hand", "there is no hand in it"},
      {"hand", "there is no hand in it"},
      {"panels", "there are none"},
      {"label", "the file holds no letters; the nodes of atoms bear their names"},
      {"arrow", "the file holds no letters"},
      {"captions", "the file holds no letters"},
      {"paint", "nothing has been touched before"},
      {"view", "whoever opens the model turns it"},
      {"view NAME", "whoever opens the model turns it"},
      {"magnify", "whoever opens the model comes close"},
      {"elastic", "a model is not felt"},
      {"modes", "a model is not felt"},
      {"frames", "a model is one frame, by --frame"},
      {"speed", "it does not move"},
      {"simulation", "a model is at rest"},
      {"pull", "a model is at rest"},
      {"temperature", "a model is at rest"},
      {"cut", "a picture is cut pixel by pixel, the triangles stay whole"},
      {"states", "names for the slider"},
      {"locked", "nobody could change it"}};
  test::checkSceneKeysInHelp("export", without);
}
