// The program's lesson on adenylate kinase: the motion of its domains between the two entries.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/structure/superposition.h"
#include "tests/lesson/shipped_lesson.h"

using namespace moltact;
using namespace moltact::test;

namespace {

const std::string kAnEnzymesDoorLesson = "an-enzymes-door";

Vec3 alphaCarbon(const ShippedScene& scene, int residue) {
  return scene.atom("protein and name CA and residue " + std::to_string(residue)).position.A;
}

}  // namespace

TEST_CASE(
    "an-enzymes-door.md has 7 steps in the open and the shut form and between the two, two searches and trials in the "
    "dark") {
  const Lesson lesson = shippedLesson(kAnEnzymesDoorLesson);
  checkCare(lesson);
  CHECK(lesson.steps.size() == 7);
  CHECK(lesson.steps.at(2).scene.then.molecule == "1ake");
  CHECK(tasksOf(lesson, "find") == 2);
  CHECK(tasksOf(lesson, "same") == 1);
}

TEST_CASE("on the core, the lid moves by 15 A in the mean and 24 A at most, the small door by 10 A and 18 A") {
  SAYS(lineSaying(kAnEnzymesDoorLesson,
                  "move by 15 Å in the mean and 24 Å at most, those of the small door (30-59) by 10 Å and 18 Å"));
  SAYS(lineSaying(kAnEnzymesDoorLesson, "The tip of the lid has moved by up to 24 Å"));
  SAYS(lineSaying(kAnEnzymesDoorLesson, "the lid turns by 52° and the"));
  SAYS(lineSaying(kAnEnzymesDoorLesson, "small door by 45°. Over all the RMSD is 7.1 Å"));
  const ShippedScene open("4ake"), shut("1ake");
  AtomPairs core;
  for (int residue = 1; residue <= 214; ++residue) {
    if ((residue > 29 && residue < 60) || (residue > 121 && residue < 160)) continue;
    const std::string text = "protein and name CA and residue " + std::to_string(residue);
    core.emplace_back(shut.select(text).at(0), open.select(text).at(0));
  }
  const auto fit = superpose(*shut.molecule, *open.molecule, core);
  REQUIRE(fit);
  const auto moves = [&](int first, int last) {
    double mean = 0.0, most = 0.0;
    for (int residue = first; residue <= last; ++residue) {
      const double way = glm::distance((*fit)(alphaCarbon(open, residue)), alphaCarbon(shut, residue));
      mean += way / (last - first + 1);
      most = std::max(most, way);
    }
    return std::pair(mean, most);
  };
  const auto [lid_mean, lid_most] = moves(122, 159);
  CHECK(lid_mean == doctest::Approx(14.7).epsilon(0.01));
  CHECK(lid_most == doctest::Approx(23.7).epsilon(0.01));
  const auto [door_mean, door_most] = moves(30, 59);
  CHECK(door_mean == doctest::Approx(10.5).epsilon(0.01));
  CHECK(door_most == doctest::Approx(18.0).epsilon(0.01));
  // By which angle each door turns on the core: the turn that is left when the door itself is laid on its other form.
  const auto turn_deg = [&](int first, int last) {
    AtomPairs door;
    for (int residue = first; residue <= last; ++residue) {
      const std::string text = "protein and name CA and residue " + std::to_string(residue);
      door.emplace_back(shut.select(text).at(0), open.select(text).at(0));
    }
    const auto own = superpose(*shut.molecule, *open.molecule, door);
    REQUIRE(own);
    const glm::dmat3 turn = own->rotation * glm::transpose(fit->rotation);
    return std::acos((turn[0][0] + turn[1][1] + turn[2][2] - 1.0) / 2.0) * 180.0 / std::numbers::pi;
  };
  CHECK(turn_deg(122, 159) == doctest::Approx(52.0).epsilon(0.02));
  CHECK(turn_deg(30, 59) == doctest::Approx(45.0).epsilon(0.02));
  AtomPairs all;
  for (int residue = 1; residue <= 214; ++residue) {
    const std::string text = "protein and name CA and residue " + std::to_string(residue);
    all.emplace_back(shut.select(text).at(0), open.select(text).at(0));
  }
  const auto whole = superpose(*shut.molecule, *open.molecule, all);
  REQUIRE(whole);
  CHECK(whole->rmsd_A == doctest::Approx(7.1).epsilon(0.01));
}

TEST_CASE("AMP has the room of a sphere of 4.4 A") {
  SAYS(lineSaying(kAnEnzymesDoorLesson, "AMP has 347 g/mol; at a density of 1.6 g/cm³ that is a ball of 4.4 Å"));
  CHECK(std::cbrt(3.0 * 347.2 / (0.602214 * 1.6) / (4.0 * std::numbers::pi)) == doctest::Approx(4.4).epsilon(0.01));
}
