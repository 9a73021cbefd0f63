// The program's lesson on base pairs: widths, places of contact and energies follow from the shipped molecules. Oracles: a
// double sum of its own with AMBER's parameters, and sweeps of the held base.
#include <cmath>

#include "engine/haptics/sweep.h"
#include "tests/lesson/pair_energy.h"
#include "tests/lesson/shipped_hand.h"

using namespace moltact;
using namespace moltact::test;

namespace {

constexpr const char* kBases = "base-pairs";
constexpr double kAway_A = 5.0;     // so far from its place the adenine of base-partners lies
constexpr double kBeside_A = 24.0;  // from the place of thymine to that of cytosine

}  // namespace

TEST_CASE(
    "base-pairs.md, and the same in German, asks a dark task before and after with charges and once without, and ranks "
    "three pairs") {
  for (const char* file : {"base-pairs", "base-pairs.de"}) {
    CAPTURE(file);
    const Lesson lesson = shippedLesson(file);
    checkCare(lesson);
    CHECK(lesson.steps.size() == 6);
    CHECK(tasksOf(lesson, "same") == 3);
    CHECK(tasksOf(lesson, "rank") == 1);
    CHECK(tasksOf(lesson, "pull") == 2);
  }
}

TEST_CASE("the nitrogens on which the sugars sit are 9.05 A apart in each of the twelve pairs of B-DNA") {
  SAYS(lineSaying(kBases, "9.05 Å in DNA between the nitrogens"));
  const ShippedScene dna("b-dna");
  for (int k = 1; k <= 12; ++k) {
    const auto nitrogen = [&](const char* chain, int residue) {
      const std::string place =
          std::string("chain ") + chain + " and residue " + std::to_string(residue) + " and name ";
      return dna.select(place + "N9").empty() ? place + "N1" : place + "N9";
    };
    CHECK(dna.between(nitrogen("A", k), nitrogen("B", 13 - k)) == doctest::Approx(9.05).epsilon(0.001));
  }
}

TEST_CASE(
    "led straight down, the adenine is stopped within 0.3 A of the same place by thymine and by cytosine, and without "
    "charges their energies on the way differ by less than 0.3 kcal/mol") {
  SAYS(lineSaying(kBases, "stopped within 0.3 Å of the same place"));
  const ShippedScene s("base-partners");
  const auto held = s.select("chain A");
  const auto body = heldBody(*s.molecule, held);
  const SphereGrid grid(s.molecule->spheres, held);
  const auto stop_A = [&](double beside) {
    const Vec3 from = body->middle.A + Vec3(beside, 0, 0);
    const Hit hit = sweep(grid, HandShape(*body, kNoRotation), from, from - Vec3(0, 8, 0));
    REQUIRE(hit.sphere >= 0);
    return 8.0 * hit.t;
  };
  const double at_thymine = stop_A(0.0), at_cytosine = stop_A(kBeside_A);
  CHECK(std::abs(at_thymine - at_cytosine) < 0.3);
  CHECK(at_thymine == doctest::Approx(kAway_A).epsilon(0.02));
  const ShippedPair thymine("base-partners", "chain B", "chain A", "van-der-waals", "water"),
      cytosine("base-partners", "chain C", "chain A", "van-der-waals", "water");
  for (double down = 0.0; down < std::min(at_thymine, at_cytosine); down += 0.25)
    CHECK(std::abs(thymine.engine({0, -down, 0}) - cytosine.engine({kBeside_A, -down, 0})) < 0.3);
}

TEST_CASE(
    "with charges the adenine's energy falls below -4 kcal/mol before thymine and rises above 1 before cytosine; the "
    "engine's is that of a double sum at 80 poses") {
  const ShippedPair thymine("base-partners", "chain B", "chain A", "all", "water"),
      cytosine("base-partners", "chain C", "chain A", "all", "water");
  double lowest = 0.0, last = 0.0;
  for (double down = 0.0; down < kAway_A - 0.35; down += 0.12) {
    const double at_thymine = thymine.engine({0, -down, 0}), at_cytosine = cytosine.engine({kBeside_A, -down, 0});
    CHECK(std::abs(at_thymine - thymine.ownSum({0, -down, 0})) < 0.02 + 5e-3 * std::abs(at_thymine));
    CHECK(std::abs(at_cytosine - cytosine.ownSum({kBeside_A, -down, 0})) < 0.02 + 5e-3 * std::abs(at_cytosine));
    lowest = std::min(lowest, at_thymine);
    last = at_cytosine;
  }
  CHECK(lowest < -4.0);
  CHECK(last > 1.0);
}

TEST_CASE(
    "A and T have a well of 4.4 kcal/mol, G and C one of 6.8, A before C one of 0.5: the deepest of 30 falls each") {
  SAYS(lineSaying(kBases, "A and T have a well of 4.4 kcal/mol, G and C one of 6.8"));
  const struct {
    const char *fixed, *held;
    double well;
  } pairs[] = {{"chain A", "chain D", -4.36}, {"chain B", "chain E", -6.8}, {"chain C", "chain F", -0.55}};
  for (const auto& p : pairs) {
    CAPTURE(p.held);
    const double well = ShippedPair(kBases, p.fixed, p.held, "all", "water").well(30);
    CHECK(std::abs(well - p.well) < 0.12);
  }
}
