// The program's lesson on the forces between two atoms: its energies, distances and forces follow from the shipped
// molecules. Oracles: the closed form of Lennard and Jones, and a double sum of its own.
#include <cmath>

#include "engine/haptics/field/minimise_pose.h"
#include "engine/haptics/field/pair_model.h"
#include "engine/lesson/pose_search.h"
#include "engine/lesson/scene_forces.h"
#include "engine/lesson/tasks/held_way.h"
#include "tests/lesson/pair_energy.h"
#include "tests/lesson/shipped_hand.h"

using namespace moltact;
using namespace moltact::test;

namespace {

constexpr const char* kAtoms = "two-atoms";

}  // namespace

TEST_CASE(
    "two-atoms.md, and the same in German, asks a dark task before and after, ranks three wells, docks once and draws "
    "a "
    "curve before a pull") {
  for (const char* file : {"two-atoms", "two-atoms.de"}) {
    CAPTURE(file);
    const Lesson lesson = shippedLesson(file);
    checkCare(lesson);
    CHECK(lesson.steps.size() == 7);
    CHECK(tasksOf(lesson, "same") == 2);
    CHECK(tasksOf(lesson, "rank") == 1);
    CHECK(tasksOf(lesson, "dock") == 1);
    CHECK(tasksOf(lesson, "pull") == 3);
  }
}

TEST_CASE(
    "two argon atoms have a well of 0.285 kcal/mol at 3.76 A; the well holds most strongly 0.41 A farther out, with 14 "
    "pN, and 2 A out with a fifth of that: the engine's energy at 200 distances, and the closed form") {
  SAYS(linesSaying(kAtoms, {"0.285 kcal/mol deep", "lies at 3.76 Å", "0.41 Å from it", "2 Å out a fifth of it is left",
                            "4.17 Å from centre to centre", "It is 14 pN there"}));
  const ShippedPair pair("argon-pair", "residue 2", "residue 1", "van-der-waals", "water");
  const double depth = 0.2846, at_A = 3.76;
  const auto closed = [&](double r) { return depth * (std::pow(at_A / r, 12) - 2 * std::pow(at_A / r, 6)); };
  for (int k = 0; k < 200; ++k) {
    const double r = 3.3 + 0.0235 * k;  // below 8 A, where the switch begins
    CHECK(pair.engine({r - at_A, 0, 0}) == doctest::Approx(closed(r)).epsilon(1e-4));
    CHECK(pair.ownSum({r - at_A, 0, 0}) == doctest::Approx(closed(r)).epsilon(1e-6));
  }
  const double sigma = at_A / std::pow(2.0, 1.0 / 6.0), steepest = sigma * std::pow(26.0 / 7.0, 1.0 / 6.0);
  CHECK(steepest == doctest::Approx(4.17).epsilon(0.002));
  CHECK(steepest - at_A == doctest::Approx(0.41).epsilon(0.02));
  const auto force_pN = [&](double r) { return kForceUnit_pN * (closed(r + 1e-5) - closed(r - 1e-5)) / 2e-5; };
  CHECK(force_pN(steepest) == doctest::Approx(14.2).epsilon(0.01));
  CHECK(force_pN(at_A + 2.0) == doctest::Approx(force_pN(steepest) / 5).epsilon(0.06));
}

TEST_CASE(
    "in water the wells of argon, waters and salt bridge are 0.28, 1.05 and 8.7 kcal/mol deep, with nothing around "
    "them "
    "6.2 and 114: the deepest of 30 falls each; the engine's energy is that of a double sum at 60 poses") {
  SAYS(linesSaying(kAtoms, {"wells of 8.7, 1.1 and 0.3 kcal/mol", "is 1.1 kcal/mol deep, nearly four times as deep",
                            "it is 6.2 kcal/mol", "A well of 114 kcal/mol", "less than a tenth of it"}));
  const struct {
    const char *fixed, *held, *medium;
    double well;
  } pairs[] = {{"chain A", "chain D", "water", -0.2846},
               {"chain B", "chain E", "water", -1.05},
               {"chain C", "chain F", "water", -8.74},
               {"chain B", "chain E", "vacuum", -6.17},
               {"chain C", "chain F", "vacuum", -113.9}};
  for (const auto& p : pairs) {
    CAPTURE(p.held);
    CAPTURE(p.medium);
    const ShippedPair pair("three-pairs", p.fixed, p.held, "all", p.medium);
    CHECK(pair.well(30) == doctest::Approx(p.well).epsilon(0.015));
    const Vec3 out = glm::normalize(pair.body().middle.A);  // away from the scene's middle
    for (int k = 0; k < 12; ++k) {
      const double own = pair.ownSum(out * (0.3 * k));
      CHECK(std::abs(pair.engine(out * (0.3 * k)) - own) < 0.01 + 2e-3 * std::abs(own));
    }
  }
}

TEST_CASE(
    "the steepest slope on the way straight off the other water is more than three times the greatest force of the "
    "argon") {
  const Lesson lesson = shippedLesson(kAtoms);
  CHECK(taskOf(lesson, "a-hydrogen-bond", "pull").values["pull"].number == 2.5);
  const ShippedPair water("three-pairs", "chain B", "chain E", "all", "water");
  const Vec3 out = glm::normalize(water.body().middle.A);
  double steepest = 0.0;
  for (double far = 0.0; far < 4.0; far += 0.05)
    steepest = std::max(steepest, kForceUnit_pN * (water.ownSum(out * (far + 0.01)) - water.ownSum(out * far)) / 0.01);
  MESSAGE("the water holds with ", steepest, " pN");
  CHECK(steepest > 3.0 * 14.2);
}
