// The shipped lesson on the grooves of DNA: their widths and depths, and what fits into which.
#include <algorithm>

#include "tests/lesson/shipped_lesson.h"

using namespace moltact;
using namespace moltact::test;

namespace {

double fromAxis(const Vec3& p) { return std::hypot(p.x, p.y); }

double nearestToAxis(const std::vector<SurfacePlace>& places) {
  double least = 1e9;
  for (const SurfacePlace& p : places) least = std::min(least, fromAxis(p.scp_A));
  return least;
}

constexpr const char* kMinorFloor = "residue 5-8 and name C2 N3 O2 N2";
constexpr const char* kMajorFloor = "residue 5-8 and name N6 O4 N7";

}  // namespace

TEST_CASE(
    "dna-grooves-blind.md has 7 steps, a way to cross and one to trace, trials in the dark and two places to find in "
    "the dark") {
  const Lesson lesson = shippedLesson("dna-grooves-blind");
  checkCare(lesson);
  CHECK(lesson.steps.size() == 7);
  CHECK(tasksOf(lesson, "trace") == 1);
  CHECK(tasksOf(lesson, "cross") == 1);
  CHECK(tasksOf(lesson, "same") == 1);
  CHECK(tasksOf(lesson, "find") == 2);
}

TEST_CASE(
    "from phosphorus to phosphorus it is 11.7 A across the minor groove of the model and 17.0 A across the major one") {
  const ShippedScene dna("b-dna");
  CHECK(dna.between("chain A and residue 8 and name P", "chain B and residue 9 and name P") ==
        doctest::Approx(11.7).epsilon(0.003));
  CHECK(dna.between("chain A and residue 5 and name P", "chain B and residue 5 and name P") ==
        doctest::Approx(17.0).epsilon(0.003));
}

TEST_CASE(
    "a water-sized probe comes to 5 A from the axis in the minor groove, 4 A in the major one, and rests 13 A out on "
    "the ridge") {
  const ShippedScene dna("b-dna");
  CHECK(nearestToAxis(dna.places(kMinorFloor, 1.4)) == doctest::Approx(5).epsilon(0.1));
  CHECK(nearestToAxis(dna.places(kMajorFloor, 1.4)) == doctest::Approx(4).epsilon(0.1));
  double farthest = 0;
  for (const SurfacePlace& p : dna.places("residue 5-8 and name OP1", 1.4))
    farthest = std::max(farthest, fromAxis(p.scp_A));
  CHECK(farthest == doctest::Approx(13).epsilon(0.03));
}

TEST_CASE(
    "a probe of 3 A comes to 6 A from the axis on the floor of the major groove; of the minor floor it touches no atom "
    "and stays 10 A out") {
  const ShippedScene dna("b-dna");
  CHECK(nearestToAxis(dna.places(kMajorFloor, 3.0)) == doctest::Approx(6).epsilon(0.05));
  CHECK(dna.openPlaces("residue 6 7 and name N6 O4 N7", 3.0) > 20);
  CHECK(dna.places(kMinorFloor, 3.0).empty());
  CHECK(dna.openPlaces("residue 6 7 and name C2 N3 O2", 1.4) > 10);
  // What holds it over the middle of the minor groove is atoms of the walls.
  const Vec3 out =
      glm::normalize(Vec3(std::cos(162 * std::numbers::pi / 180), std::sin(162 * std::numbers::pi / 180), 0));
  double rests_A = 0;
  for (const Atom& a : dna.molecule->atoms) {
    const double along = glm::dot(a.position.A, out), off = glm::distance(a.position.A, out * along),
                 grown = a.radius_A + 3.0;
    if (off < grown) rests_A = std::max(rests_A, along + std::sqrt(grown * grown - off * off));
  }
  CHECK(rests_A == doctest::Approx(10.5).epsilon(0.06));
}
