// The program's lesson on adenylate kinase: the motion of its domains, and what can be touched behind them, agree with
// the two entries.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/structure/superposition.h"
#include "tests/lesson/shipped_lesson.h"

using namespace moltact;
using namespace moltact::test;

namespace {

const std::string kLesson = "an-enzymes-door";
const char* const kSixteen = "(residue 13 and name NZ) or (residue 36 88 123 156 167 and name NE NH1 NH2)";

Vec3 alphaCarbon(const ShippedScene& scene, int residue) {
  return scene.atom("protein and name CA and residue " + std::to_string(residue)).position.A;
}

/// The alpha carbons of these residues, in the order of their numbers.
std::vector<Vec3> alphaCarbons(const ShippedScene& scene, int first, int last) {
  std::vector<Vec3> out;
  for (int r = first; r <= last; ++r) out.push_back(alphaCarbon(scene, r));
  return out;
}

double nearest_A(const ShippedScene& scene) {
  double least = 1e9;
  for (const Vec3& lid : alphaCarbons(scene, 122, 159))
    for (const Vec3& door : alphaCarbons(scene, 30, 59)) least = std::min(least, glm::distance(lid, door));
  return least;
}

}  // namespace

TEST_CASE(
    "an-enzymes-door.md has 7 steps in the open and the shut form and between the two, two searches and trials in the "
    "dark") {
  const Lesson lesson = shippedLesson(kLesson);
  checkCare(lesson);
  CHECK(lesson.steps.size() == 7);
  CHECK(lesson.steps.at(2).scene.then.molecule == "1ake");
  CHECK(tasksOf(lesson, "find") == 2);
  CHECK(tasksOf(lesson, "same") == 1);
}

TEST_CASE(
    "lid and small door come from 19.4 A to 5.4 A of each other; on the core, the lid moves by 15 A in the mean and 24 "
    "A "
    "at most, the small door by 10 A and 18 A") {
  CAPTURE(lineSaying(kLesson, "19.4 Å apart in the open form and 5.4 Å in the shut one"));
  CAPTURE(lineSaying(kLesson,
                     "move by 15 Å in the mean and 24 Å at most, those of the small door (30-59) by 10 Å and 18 Å"));
  CAPTURE(lineSaying(kLesson, "The tip of the lid has moved by up to 24 Å"));
  CAPTURE(lineSaying(kLesson, "it is 17.0 Å open and 3.7 Å shut"));
  CAPTURE(lineSaying(kLesson, "the lid turns by 52° and the"));
  CAPTURE(lineSaying(kLesson, "small door by 45°. Over all the RMSD is 7.1 Å"));
  const ShippedScene open("4ake"), shut("1ake");
  CHECK(nearest_A(open) == doctest::Approx(19.4).epsilon(0.003));
  CHECK(nearest_A(shut) == doctest::Approx(5.4).epsilon(0.01));
  CHECK(open.between("residue 36 and name CZ", "residue 156 and name CZ") == doctest::Approx(17.0).epsilon(0.003));
  CHECK(shut.between("residue 36 and name CZ", "residue 156 and name CZ") == doctest::Approx(3.7).epsilon(0.01));
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

TEST_CASE(
    "the rim that is pressed is where the doors meet: each of its residues lies within 6 A of the other door and can "
    "be "
    "touched straight from outside; the enzyme is 59 A long open and 48 A shut") {
  CAPTURE(lineSaying(kLesson, "press: residue 33 40 54 127 128 129 131 157"));
  CAPTURE(lineSaying(kLesson, "The enzyme is some 50 Å to 60 Å long"));
  const ShippedScene open("4ake"), shut("1ake");
  for (const char* residue : {"33", "40", "54", "127", "128", "129", "131", "157"}) {
    CAPTURE(residue);
    const std::string rim = std::string("protein and residue ") + residue;
    const std::string other = std::stoi(residue) < 60 ? "residue 122-159" : "residue 30-59";
    CHECK_FALSE(shut.select(rim + " and within 6 Å of (protein and " + other + ")").empty());
    CHECK(shut.openPlaces(rim, 1.4) > 0);
  }
  const auto length_A = [](const ShippedScene& s) {
    double most = 0.0;
    const auto all = alphaCarbons(s, 1, 214);
    for (const Vec3& a : all)
      for (const Vec3& b : all) most = std::max(most, glm::distance(a, b));
    return most;
  };
  CHECK(length_A(open) == doctest::Approx(59.0).epsilon(0.01));
  CHECK(length_A(shut) == doctest::Approx(48.0).epsilon(0.01));
}

TEST_CASE("AMP has the room of a sphere of 4.4 A") {
  CAPTURE(lineSaying(kLesson, "AMP has 347 g/mol; at a density of 1.6 g/cm³ that is a ball of 4.4 Å"));
  CHECK(std::cbrt(3.0 * 347.2 / (0.602214 * 1.6) / (4.0 * std::numbers::pi)) == doctest::Approx(4.4).epsilon(0.01));
}
