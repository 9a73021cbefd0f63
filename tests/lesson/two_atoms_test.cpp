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
    "two-atoms.md, and the same in German, asks a dark task before and after, ranks three wells, docks once and draws a "
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
    "pN, and beyond 3 A with less than a tenth of that: the engine's energy at 200 distances, and the closed form") {
  SAYS(linesSaying(kAtoms, {"0.285 kcal/mol deep", "lies at 3.76 Å", "0.41 Å from it", "beyond 3 Å it is gone",
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
  CHECK(force_pN(at_A + 3.0) < 0.11 * force_pN(steepest));
}

TEST_CASE("wells of the three pairs") {
  for (const char* medium : {"water", "vacuum"})
    for (const auto& [fixed, held] : {std::pair("chain A", "chain D"), std::pair("chain B", "chain E"), std::pair("chain C", "chain F")}) {
      const ShippedPair pair("three-pairs", fixed, held, "all", medium);
      MESSAGE(medium, " ", held, " file: engine ", pair.engine(Vec3(0.0)), " own ", pair.ownSum(Vec3(0.0)), " well ", pair.well(40));
    }
}
