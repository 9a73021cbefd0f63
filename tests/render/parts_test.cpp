// The parts that need no graphics: names of shapes, intersections, ambient_occlusion, PNG files. Oracles: closed forms.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

#include "engine/render/ambient_occlusion.h"
#include "engine/render/picture.h"
#include "engine/render/view_scene.h"

using namespace moltact;

TEST_CASE("every shape is switched by its own name, and 'haptic' is the group of the seven haptic ones") {
  for (const ViewPartInfo& s : viewParts()) {
    const auto set = parseViewParts(s.name);
    REQUIRE(bool(set));
    for (const ViewPartInfo& other : viewParts()) CHECK(set->has(other.part) == (other.part == s.part));
  }
  const auto haptic = parseViewParts("haptic");
  int count = 0;
  for (const ViewPartInfo& s : viewParts()) {
    CHECK(haptic->has(s.part) == s.haptic);
    count += s.haptic;
  }
  CHECK(count == 7);
}

TEST_CASE("an unknown shape names the known ones") {
  const auto set = parseViewParts("atoms,conez");
  REQUIRE_FALSE(bool(set));
  CHECK(set.problem().text().find("conez") != std::string::npos);
  CHECK(set.problem().text().find("circles, points, cones") != std::string::npos);
}

TEST_CASE(
    "a ball alone has full light; in a block of 1000 the middle is darker than a corner, whose light comes from "
    "outside") {
  CHECK(ambientOcclusion(std::vector<Ball>{{Vec3(0), 1.7}})[0].level == 1.0f);
  std::vector<Ball> block;
  for (int x = 0; x < 10; ++x)
    for (int y = 0; y < 10; ++y)
      for (int z = 0; z < 10; ++z) block.push_back({2.2 * Vec3(x, y, z), 1.7});
  const auto light = ambientOcclusion(block);
  const AmbientOcclusion corner = light.front(), middle = light[555];
  CHECK(middle.level < 0.3f);
  CHECK(corner.level > middle.level + 0.3f);
  CHECK(glm::dot(corner.slope, glm::vec3(-1)) > 0.1f);
}

TEST_CASE("two balls 2 million A apart are lit without a field of that size") {
  const auto light = ambientOcclusion(std::vector<Ball>{{Vec3(-1e6, 0, 0), 1.7}, {Vec3(1e6, 0, 0), 1.7}});
  CHECK(light[0].level == 1.0f);
}

TEST_CASE("a picture of 5 x 3 pixels comes back from its PNG file byte for byte") {
  Picture picture{5, 3, {}};
  for (int i = 0; i < 45; ++i) picture.rgb.push_back(std::uint8_t(i * 5));
  const auto file = std::filesystem::temp_directory_path() / "moltact-picture-test.png";
  const auto problem = writePng(file, picture);
  CHECK_FALSE(problem);
  const auto back = readPng(file);
  REQUIRE(bool(back));
  CHECK(back->width_px == 5);
  CHECK(back->rgb == picture.rgb);
  std::filesystem::remove(file);
}

TEST_CASE("a PNG in a folder that is not there, and one that is no PNG, give problems that name the file") {
  const auto problem = writePng("/no/such/folder/a.png", Picture{1, 1, {0, 0, 0}});
  REQUIRE(problem);
  CHECK(problem->text().find("/no/such/folder/a.png") != std::string::npos);
  const auto file = std::filesystem::temp_directory_path() / "moltact-not-a-picture.png";
  std::ofstream(file) << "not a picture";
  CHECK_FALSE(bool(readPng(file)));
  std::filesystem::remove(file);
}
