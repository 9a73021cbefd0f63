// The program's lesson on zinc fingers: which atoms are free or covered, and which residue contacts which base, agrees
// with the entry.
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <tuple>

#include "tests/lesson/shipped_hand.h"

using namespace moltact;
using namespace moltact::test;

namespace {

const std::string kLesson = "a-protein-reads-dna";
const char* const kTwelve = "(residue 2 4 6 7 8 and name N7 O6) or (residue 9 and name N7 N6)";

}  // namespace

TEST_CASE("a-protein-reads-dna.md has 8 steps, a way down the groove, a search and trials in the dark") {
  const Lesson lesson = shippedLesson(kLesson);
  checkCare(lesson);
  CHECK(lesson.steps.size() == 8);
  CHECK(tasksOf(lesson, "trace") == 1);
  CHECK(tasksOf(lesson, "find") == 1);
  CHECK(tasksOf(lesson, "same") == 1);
}

TEST_CASE("the DNA without protein is that of the complex, atom by atom") {
  const ShippedScene bare("1a1f-dna"), complex("1a1f");
  const auto same = complex.select("chain B C");
  REQUIRE(same.size() == bare.spheres.size());
  for (std::size_t i = 0; i < same.size(); ++i)
    CHECK(glm::distance(bare.spheres[i].centre_A, complex.spheres[same[i]].centre_A) < 1e-9);
}

TEST_CASE(
    "four arginines hold four guanines by two bonds of 2.8 A to 3.1 A each; His 149, Asn 121 and Asp "
    "118 as in the lesson") {
  CAPTURE(lineSaying(kLesson, "Arg 180 to guanine 2 2.8 Å and 2.8 Å"));
  CAPTURE(lineSaying(kLesson, "His 149 holds guanine 6 (2.9 Å)"));
  CAPTURE(lineSaying(kLesson, "Arginines 174, 146 and 124 hold guanines 4, 7 and 8"));
  const ShippedScene complex("1a1f");
  for (const auto& [one, other, stated_A] : {std::tuple{"residue 180 and name NH1", "residue 2 and name O6", 2.8},
                                             std::tuple{"residue 180 and name NH2", "residue 2 and name N7", 2.8},
                                             std::tuple{"residue 174 and name NH1", "residue 4 and name N7", 2.9},
                                             std::tuple{"residue 174 and name NH2", "residue 4 and name O6", 2.9},
                                             std::tuple{"residue 146 and name NH2", "residue 7 and name O6", 3.0},
                                             std::tuple{"residue 146 and name NH1", "residue 7 and name N7", 3.1},
                                             std::tuple{"residue 124 and name NH1", "residue 8 and name O6", 3.0},
                                             std::tuple{"residue 124 and name NH2", "residue 8 and name N7", 2.9},
                                             std::tuple{"residue 149 and name NE2", "residue 6 and name N7", 2.9},
                                             std::tuple{"residue 121 and name OD1", "residue 9 and name N6", 3.0},
                                             std::tuple{"residue 121 and name ND2", "residue 9 and name N7", 3.0},
                                             std::tuple{"residue 118 and name OD2", "residue 10 and name N4", 2.9}}) {
    CAPTURE(one);
    CAPTURE(other);
    CHECK(std::abs(complex.between(one, other) - stated_A) < 0.061);
  }
  for (const char* arginine : {"180", "174", "146", "124"})
    CHECK(complex.select(std::string("resname ARG and name CA and residue ") + arginine).size() == 1);
  for (const char* guanine : {"2", "4", "6", "7", "8"})
    CHECK(complex.select(std::string("resname DG and chain B and name O6 and residue ") + guanine).size() == 1);
}

TEST_CASE(
    "the fingers are residues 103 to 133, 134 to 161 and 162 on, each with a zinc ion held by two Cys and two His") {
  CAPTURE(lineSaying(kLesson, "of: (residue 103-133) then (residue 134-161) then (residue 162-187)"));
  const ShippedScene complex("1a1f");
  for (const char* finger : {"103-133", "134-161", "162-187"}) {
    CAPTURE(finger);
    const std::string in = std::string("residue ") + finger + " and ";
    CHECK(complex.select(in + "resname CYS and name SG and within 3.6 Å of (element Zn)").size() == 2);
    CHECK(complex.select(in + "resname HIS and name NE2 and within 2.6 Å of (element Zn)").size() == 2);
  }
}

TEST_CASE("15 letters have fewer forms than human DNA has places, 18 letters more: six fingers") {
  CAPTURE(lineSaying(
      kLesson, "A text of 15 letters has about 1 thousand million forms, one of 18 letters about 69 thousand million"));
  CAPTURE(lineSaying(kLesson, "With five, a text would be found by chance at about three places"));
  CHECK(std::pow(4.0, 15) == 1073741824.0);
  CHECK(std::pow(4.0, 18) == 68719476736.0);
  CHECK(3.2e9 / std::pow(4.0, 15) == doctest::Approx(3.0).epsilon(0.02));
  CHECK(3.2e9 > std::pow(4.0, 15));
  CHECK(6.4e9 < std::pow(4.0, 18));
}

TEST_CASE("the way down the groove is passed by a hand that slides, by none that jabs the same atoms or one of them") {
  const Lesson lesson = shippedLesson(kLesson);
  const ShippedScene bare("1a1f-dna");
  const TaskSpec& spec = taskOf(lesson, "take-the-fingers-away", "trace");
  std::vector<std::string> way;
  for (const char* edge : {"2 and name O6", "3 and name N4", "4 and name O6", "5 and name O4", "6 and name O6",
                           "7 and name O6", "8 and name O6"})
    way.push_back(std::string("residue ") + edge);
  // Each is touched from the side on which it lies most open, for the groove winds.
  const auto done = [&](const std::vector<std::string>& atoms, bool jabbing) {
    const std::unique_ptr<Task> task = makeTask(spec, *bare.molecule);
    Hand hand{*task};
    std::optional<Vec3> last_A;
    for (const std::string& name : atoms) {
      Vec3 open(0.0);
      for (const SurfacePlace& p : bare.places(name, 1.4, 600))
        if (openFromOutside(bare.spheres, p, 1.4)) open += p.outward;
      const std::vector<std::int32_t> atom{static_cast<std::int32_t>(bare.select(name).at(0))};
      const Vec3 place_A = restingOn(bare, name, glm::normalize(open), 1.4);
      if (jabbing)
        hand.away(0.5);
      else if (last_A)
        hand.slide(atom, *last_A, place_A);
      hand.touch(atom, 0.3, 0.5, place_A);
      last_A = place_A;
    }
    return task->done();
  };
  CHECK(done(way, false));
  CHECK_FALSE(done(way, true));
  CHECK_FALSE(done({way[2]}, false));
  CHECK_FALSE(done({way.rbegin(), way.rend()}, false));
}

TEST_CASE("finger 3 reads letters 2 to 4, GCG, finger 2 letters 5 to 7, TGG, finger 1 letters 8 to 10, GAC") {
  CAPTURE(lineSaying(
      kLesson, "Finger 3 reads letters 2 to 4 (GCG), finger 2 letters 5 to 7 (TGG), finger 1 letters 8 to 10 (GAC)"));
  const ShippedScene complex("1a1f");
  const std::string text = "GCGTGGGAC";
  for (int letter = 2; letter <= 10; ++letter) {
    CAPTURE(letter);
    const std::string one = "chain B and residue " + std::to_string(letter);
    CHECK(complex.select(one + " and name P and resname D" + text[std::size_t(letter - 2)]).size() == 1);
  }
  // Which finger holds the letters of this strand by the atoms of its side chains that come near their edges.
  for (const auto& [finger, letters] : {std::pair{"residue 162-187", "2 4"}, std::pair{"residue 134-161", "6 7"},
                                        std::pair{"residue 103-133", "8 9 10"}})
    CHECK(complex
              .select(std::string("chain A and sidechain and ") + finger +
                      " and within 3.2 Å of (chain B and residue " + letters + " and name N7 O6 N6 N4)")
              .size() >= 2);
}
