// The program's lesson on the four chains of haemoglobin: its interfaces, gaps and numbers agree with the entry.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "tests/lesson/shipped_lesson.h"

using namespace moltact;
using namespace moltact::test;

TEST_CASE(
    "four-chains-as-one.md has 6 steps in one molecule, with three borders to slide over and a search in the dark") {
  for (const char* file : {"four-chains-as-one", "four-chains-as-one.de"}) {
    CAPTURE(file);
    const Lesson lesson = shippedLesson(file);
    checkCare(lesson);
    CHECK(lesson.steps.size() == 6);
    CHECK(tasksOf(lesson, "cross") == 4);
    CHECK(tasksOf(lesson, "find") == 1);
    CHECK(lesson.molecules.size() == 1);
  }
}

TEST_CASE(
    "the chains have 141 and 146 amino acids, the irons are 24 A to 40 A apart, each 2.03 A to 2.17 A from its "
    "histidine") {
  const ShippedScene whole("2hhb");
  const char* chains[] = {"A", "B", "C", "D"};
  double least = 1e9, most = 0;
  for (int i = 0; i < 4; ++i) {
    const std::string c = std::string("chain ") + chains[i];
    CHECK(whole.select(c + " and protein and name CA").size() == (i % 2 ? 146 : 141));
    const double bond =
        whole.between(c + " and element Fe", c + " and resname HIS and name NE2 and residue " + (i % 2 ? "92" : "87"));
    CHECK((bond > 2.025 && bond < 2.175));
    for (int j = 0; j < i; ++j) {
      const double d = whole.between(c + " and element Fe", std::string("chain ") + chains[j] + " and element Fe");
      least = std::min(least, d);
      most = std::max(most, d);
    }
  }
  CHECK(least == doctest::Approx(24).epsilon(0.02));
  CHECK(most == doctest::Approx(40).epsilon(0.02));
}

TEST_CASE(
    "from nitrogen to nitrogen lysines 82 of the beta chains are 9.3 A apart, both are met straight from outside, and "
    "the two phosphates lie 3.6 A and 4.1 A from the beginnings of the beta chains") {
  const std::string says =
      linesSaying("four-chains-as-one", {"it is 9.3 Å across the gap", "3.6 Å and 4.1 Å from the nitrogens"});
  CAPTURE(says);
  const ShippedScene whole("2hhb");
  CHECK(whole.between("chain B and residue 82 and name NZ", "chain D and residue 82 and name NZ") ==
        doctest::Approx(9.3).epsilon(0.005));
  for (const char* lysine : {"chain B and residue 82 and name NZ", "chain D and residue 82 and name NZ"})
    CHECK(whole.openPlaces(lysine, 1.4) > 100);
  const auto phosphorus = whole.select("element P");
  REQUIRE(phosphorus.size() == 2);
  std::vector<double> least_A;
  for (const auto i : phosphorus) {
    double d = 1e9;
    for (const char* chain : {"B", "D"})
      d = std::min(d,
                   glm::distance(
                       whole.molecule->spheres[i].centre_A,
                       whole.atom(std::string("chain ") + chain + " and protein and residue 1 and name N").position.A));
    least_A.push_back(d);
  }
  std::sort(least_A.begin(), least_A.end());
  CHECK(least_A[0] == doctest::Approx(3.6).epsilon(0.01));
  CHECK(least_A[1] == doctest::Approx(4.1).epsilon(0.01));
  for (const char* chain : {"B", "D"}) {
    const std::string c = std::string("chain ") + chain + " and protein and name CA and residue ";
    for (const auto& [number, name] :
         {std::pair{"1", "VAL"}, std::pair{"2", "HIS"}, std::pair{"82", "LYS"}, std::pair{"143", "HIS"}})
      CHECK(whole.select(c + number + " and resname " + name).size() == 1);
  }
}

TEST_CASE(
    "in the beta chains histidine 146 leans on aspartate 94 at 2.8 A and 2.7 A, the end of the chain on lysine 40 of "
    "an "
    "alpha chain at 2.5 A, and arginine 141 of A on aspartate 126 of C; all that are slid over lie open to a water "
    "molecule") {
  const std::string says =
      linesSaying("four-chains-as-one",
                  {"from nitrogen to oxygen it is 2.8 Å", "2.8 Å (chain B) and 2.7 Å (chain D) from Asp 94 OD1",
                   "besides 2.5 Å from Lys 40 of an alpha chain (C, A)", "2.7 Å and 3.0 Å from Asp 126 of C"});
  CAPTURE(says);
  const ShippedScene whole("2hhb");
  const auto nearest_A = [&](const std::string& one, const std::string& other) {
    double least = 1e9;
    for (const auto a : whole.select(one))
      for (const auto b : whole.select(other))
        least = std::min(least, glm::distance(whole.spheres[a].centre_A, whole.spheres[b].centre_A));
    return least;
  };
  for (const auto& [chain, stated_A] : {std::pair{"B", 2.8}, std::pair{"D", 2.7}}) {
    const std::string c = std::string("chain ") + chain + " and protein and residue ";
    CHECK(std::abs(whole.between(c + "146 and name NE2", c + "94 and name OD1") - stated_A) < 0.05);
    CHECK(whole.select(c + "147").empty());
  }
  CHECK(std::abs(nearest_A("chain B and protein and residue 146 and name O OXT", "chain C and residue 40 and name NZ") -
                 2.5) < 0.05);
  CHECK(std::abs(nearest_A("chain D and protein and residue 146 and name O OXT", "chain A and residue 40 and name NZ") -
                 2.5) < 0.05);
  const std::string arginine = "chain A and protein and residue 141 and name ",
                    aspartate = "chain C and protein and residue 126 and name ";
  CHECK(std::abs(nearest_A(arginine + "NH1", aspartate + "OD2") - 2.7) < 0.05);
  CHECK(std::abs(nearest_A(arginine + "NH2", aspartate + "OD2") - 3.0) < 0.05);
  for (const char* name :
       {"146 and name ND1", "146 and name CE1", "146 and name NE2", "94 and name OD1", "94 and name OD2"})
    CHECK(whole.openPlaces(std::string("chain B and protein and residue ") + name, 1.4) > 0);
}

TEST_CASE(
    "with Hill's equation, n = 2.7 and half full at 3.5 kPa, 97 of 100 haems hold oxygen at 13 kPa and 18 at 2 kPa; "
    "without cooperativity 79 and 36") {
  const std::string line = linesSaying(
      "four-chains-as-one", {"97 of 100 haems hold oxygen | 79 |", "at 2 kPa | 18 | 36 |", "79 of 100 against 43"});
  CAPTURE(line);
  const auto full = [](double kPa, double n) { return 100.0 / (1.0 + std::pow(3.5 / kPa, n)); };
  CHECK(std::round(full(13.0, 2.7)) == 97.0);
  CHECK(std::round(full(2.0, 2.7)) == 18.0);
  CHECK(std::round(full(13.0, 1.0)) == 79.0);
  CHECK(std::round(full(2.0, 1.0)) == 36.0);
  CHECK(97 - 18 == 79);
  CHECK(79 - 36 == 43);
}

TEST_CASE(
    "an alpha and a beta chain of different pairs touch: A and D, and C and B, have atoms within 4 A of one another") {
  const std::string line =
      lineSaying("four-chains-as-one", "alpha chain A lies against beta chain D, of the other pair");
  CAPTURE(line);
  const ShippedScene whole("2hhb");
  CHECK(whole.select("chain A and within 4 Å of (chain D)").size() > 30);
  CHECK(whole.select("chain C and within 4 Å of (chain B)").size() > 30);
  // The pair whose border is the larger one moves as a whole: A with B.
  CHECK(whole.select("chain A and within 4 Å of (chain B)").size() >
        whole.select("chain A and within 4 Å of (chain D)").size());
}
