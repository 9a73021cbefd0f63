// The region that a scene magnifies, in closed form; the molecule is the ten-atom one of small_molecules.h.
#include "engine/lesson/lesson_region.h"

#include <doctest/doctest.h>

#include "engine/lesson/check.h"
#include "engine/workspace/scale.h"
#include "tests/lesson/small_molecules.h"

using namespace moltact;

TEST_CASE(
    "two atoms 1 A apart, radius 1.7 A, probe 1.4 A: the region's middle is between them and its radius 3.6 A; none "
    "where none is asked for") {
  const Molecule molecule = mixedMolecule();
  SceneSpec scene;
  CHECK_FALSE(magnifiedRegion(scene, molecule));
  scene.magnify = *parseSelection("ligand HEM");  // at x = 6 and 7
  const std::optional<Region> region = magnifiedRegion(scene, molecule);
  REQUIRE(region);
  CHECK(glm::distance(region->centre.A, Vec3(6.5, 0, 0)) < 1e-12);
  CHECK(region->radius_A == doctest::Approx(3.6));
  Workspace whole;
  const Workspace fine = magnified(whole, *region, DeviceSpecs{});
  CHECK(fine.A_per_mm == doctest::Approx(3.6 / 35.0));
  scene.magnify = *parseSelection("residue 999");
  CHECK_FALSE(magnifiedRegion(scene, molecule));
}

TEST_CASE("a scene that magnifies what the molecule does not have is reported by the check") {
  const std::string head = "---\ntitle: T\nminutes: 1\ngoals: G\nmolecules: mix\nauthor: A\nlicence: L\n---\n";
  const auto mix = [](const NamedMolecule&) -> Expected<std::shared_ptr<const Molecule>> {
    return std::make_shared<const Molecule>(mixedMolecule());
  };
  const LessonCheck check =
      checkLesson("l.md", head + "## S\n```scene\nmolecule: mix\nmagnify: residue 999\n```\nText.\n", mix);
  REQUIRE(check.errors.size() == 1);
  CHECK((check.errors[0].line == 12 && check.errors[0].column > 1));
}
