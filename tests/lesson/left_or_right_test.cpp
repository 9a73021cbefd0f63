// The program's lesson on mirror images: the reach of its groups, the sides on which they lie, and that guessing, jabbing
// or the wrong direction do not pass. What stands here is no fact of the lesson: facts know no mirror image, no side of a
// view, no reach with the atoms' radii, no count of residues by their form, and no hand that does a task.
#include <algorithm>

#include "tests/lesson/shipped_hand.h"

using namespace moltact;
using namespace moltact::test;

namespace {

constexpr const char* kLeftOrRightLesson = "left-or-right";

/// Positive where CO, R, N go round with the clock for one who looks from the hydrogen: the L form.
double handedness(const Vec3& ca, const Vec3& n, const Vec3& c, const Vec3& cb) {
  return glm::dot(glm::cross(n - ca, c - ca), cb - ca);
}

double handedness(const ShippedScene& s, const std::string& of) {
  const auto at = [&](const char* name) { return s.atom(of + " and name " + name).position.A; };
  return handedness(at("CA"), at("N"), at("C"), at("CB"));
}

/// How far the atoms reach out from the middle carbon, their own radii included.
double reach_A(const ShippedScene& s, const std::string& atoms) {
  const Vec3 ca = s.atom("chain A and name CA").position.A;
  double most = 0;
  for (const std::uint32_t a : s.select(atoms))
    most = std::max(most, glm::distance(s.molecule->spheres[a].centre_A, ca) + s.molecule->spheres[a].radius_A);
  return most;
}

}  // namespace

TEST_CASE(
    "left-or-right.md has 6 steps and 3 extra ones, five rounds to trace, one of them unseen, two lengths to measure, "
    "and eight trials in the dark, before and after, of which seven must be right, 9 of 256 for a guesser") {
  const Lesson lesson = shippedLesson(kLeftOrRightLesson);
  checkCare(lesson);
  CHECK(lesson.steps.size() == 9);
  CHECK(tasksOf(lesson, "trace") == 5);
  CHECK(tasksOf(lesson, "measure") == 2);
  REQUIRE(tasksOf(lesson, "same") == 2);
  int unseen = 0;
  const ShippedScene phe("phenylalanine-pair");
  for (const Step& s : lesson.steps) unseen += s.scene.hide.given() && s.scene.hide.select(*phe.molecule).size() == 46;
  CHECK(unseen == 1);
  const std::string chance = lineSaying(kLeftOrRightLesson, "in 9 of 256 rounds, 3.5 %");
  CAPTURE(chance);
  const TaskSpec& same = taskOf(lesson, "two-powders-in-the-dark", "same");
  CHECK(same.values["trials"].number == 8);
  CHECK(same.values["right"].number == 7);
  CHECK((8 + 1) / 256.0 == doctest::Approx(0.035).epsilon(0.01));
}

TEST_CASE("chain B of both pairs is the mirror image of chain A, to 0.001 A") {
  for (const char* name : {"alanine-pair", "phenylalanine-pair"}) {
    CAPTURE(name);
    const ShippedScene s(name);
    const auto l = s.select("chain A"), d = s.select("chain B");
    REQUIRE(l.size() == d.size());
    for (std::size_t k = 0; k < l.size(); ++k) {
      const PlacedAtom a = s.molecule->at(l[k]), b = s.molecule->at(d[k]);
      CHECK(a.name == b.name);
      CHECK(glm::distance(a.position.A * Vec3(-1, 1, 1), b.position.A) < 0.001);
    }
  }
}

TEST_CASE("from the middle carbon of alanine CH3 reaches 3.35 A, NH3+ 3.28 A and COO- 3.89 A") {
  const std::string line = lineSaying(kLeftOrRightLesson, "reaches out 3.35 Å, NH₃⁺ 3.28 Å and COO⁻ 3.89 Å");
  CAPTURE(line);
  const ShippedScene s("alanine-pair");
  CHECK(reach_A(s, "chain A and name HB1 HB2 HB3") == doctest::Approx(3.35).epsilon(0.002));
  CHECK(reach_A(s, "chain A and name H1 H2 H3") == doctest::Approx(3.28).epsilon(0.002));
  CHECK(reach_A(s, "chain A and name O OXT") == doctest::Approx(3.89).epsilon(0.002));
}

TEST_CASE(
    "turned to the front each form has its hydrogen toward the viewer, COO- above, and the ring at the right in L, at "
    "the left in D") {
  const std::string line = lineSaying(kLeftOrRightLesson, "at the right it is L, and at the left it is D");
  CAPTURE(line);
  const ShippedScene s("phenylalanine-pair");
  for (const double side : {1.0, -1.0}) {
    const std::string chain = side > 0 ? "chain A" : "chain B";
    const auto at = [&](const char* name) { return s.atom(chain + " and name " + name).position.A; };
    // Who looks from +x has -z at the right, who looks from -x has +z there.
    const auto right = [&](const char* name) { return -side * (at(name).z - at("CA").z); };
    CHECK(side * (at("HA").x - at("CA").x) == doctest::Approx(1.09).epsilon(0.002));
    CHECK(at("C").y - at("CA").y > 1.0);
    CHECK(side * right("CZ") > 4.0);
    CHECK(side * right("N") < -1.0);
  }
}

TEST_CASE(
    "from the tip of phenylalanine's ring to NH3+ it is up to 10.6 A in either form, and 8 A or more to be right") {
  const std::string line = lineSaying(kLeftOrRightLesson, "it is up to 10.6 Å in either form");
  CAPTURE(line);
  const Lesson lesson = shippedLesson(kLeftOrRightLesson);
  const ShippedScene s("phenylalanine-pair");
  for (const char* chain : {"chain A", "chain B"}) {
    double most_A = 0, least_A = 1e9;
    for (const char* h : {"H1", "H2", "H3"}) {
      const double centres_A = s.between(std::string(chain) + " and name HZ", std::string(chain) + " and name " + h);
      most_A = std::max(most_A, centres_A + 2 * 1.20);
      least_A = std::min(least_A, centres_A);
    }
    CHECK(most_A == doctest::Approx(10.6).epsilon(0.003));
    CHECK(least_A > 7.8);
  }
  const auto at = lesson.find("what-the-tongue-feels");
  REQUIRE(at);
  for (const TaskSpec& t : lesson.steps[*at].tasks) {
    CHECK(t.values["between"].low == 8);
    CHECK(t.values["between"].high > 10.6);
  }
}

TEST_CASE("of ubiquitin's 76 amino acids 70 are L") {
  const std::string says = lineSaying(kLeftOrRightLesson, "with 70 of the 76 amino acids of this protein");
  CAPTURE(says);
  const ShippedScene s("1ubq");
  int l = 0;
  for (const Residue& r : s.molecule->residues) {
    if (r.name != "GLY") l += handedness(s, "residue " + std::to_string(r.number)) > 1.5;
  }
  CHECK(l == 70);
}

TEST_CASE(
    "the round on alanine 46 of ubiquitin lies open to whoever looks from where its hydrogen would be, as the view "
    "does") {
  const ShippedScene s("1ubq");
  const auto at = [&](const char* name) { return s.atom(std::string("residue 46 and name ") + name).position.A; };
  const Vec3 ca = at("CA");
  const Vec3 h =
      -glm::normalize(glm::normalize(at("N") - ca) + glm::normalize(at("C") - ca) + glm::normalize(at("CB") - ca));
  Vec3 low(1e9), high(-1e9);
  for (const Sphere& a : s.molecule->spheres) {
    low = glm::min(low, a.centre_A);
    high = glm::max(high, a.centre_A);
  }
  const Vec3 seen_from = glm::normalize(s.atom("residue 6 and name NZ").position.A - 0.5 * (low + high));
  CHECK(glm::dot(h, seen_from) > 0.99);
  for (const char* name : {"C O", "CB", "N"}) {
    CAPTURE(name);
    int open = 0;
    for (SurfacePlace p : s.places(std::string("residue 46 and name ") + name, 1.4)) {
      p.outward = h;
      open += openFromOutside(s.spheres, p, 1.4);
    }
    CHECK(open > 20);
  }
}

TEST_CASE(
    "the rounds are passed by a hand that slides the right way round, by none that jabs the same atoms, goes the other "
    "way or leaves the side chain out") {
  const Lesson lesson = shippedLesson(kLeftOrRightLesson);
  struct Round {
    const char *step, *molecule, *chain;
    std::vector<const char*> way;                  // that passes
    std::vector<std::vector<const char*>> astray;  // that do not
  };
  const std::vector<const char*> small{"OXT", "HB1", "HB3", "HB2", "H2", "H3", "O"},
      ring{"OXT", "CD2", "CE1", "HZ", "CE1", "HB2", "H2"};
  // A hand that touches NH3+ first reaches the side chain too late. One that omits the ring moves straight down the
  // middle, over the alpha hydrogen.
  const std::vector<std::vector<const char*>> small_astray{{"OXT", "H3", "H2", "HB2", "HB1"},
                                                           {"OXT", "H3", "HB1", "H3"}},
      ring_astray{{"OXT", "H2", "HA", "CE1"},
                  {"OXT", "HA", "HB2", "H2"},
                  {"OXT", "HB2", "H2"},
                  {"O", "H3", "H2", "HB2", "CE1"}};
  for (const Round& r : {Round{"round-the-carbon", "alanine-pair", "chain A", small, small_astray},
                         Round{"its-mirror-image", "alanine-pair", "chain B", small, small_astray},
                         Round{"a-side-chain-that-stands-out", "phenylalanine-pair", "chain A", ring, ring_astray},
                         Round{"which-one-is-it", "phenylalanine-pair", "chain B", ring, ring_astray}}) {
    CAPTURE(r.step);
    const ShippedScene s(r.molecule);
    const TaskSpec& spec = taskOf(lesson, r.step, "trace");
    const auto named = [&](const char* name) { return std::string(r.chain) + " and name " + name; };
    const auto all = [&](const std::vector<const char*>& names) {
      std::vector<std::string> out;
      for (const char* name : names) out.push_back(named(name));
      return out;
    };
    const std::vector<std::string> round = all(r.way);
    // From the side of the hydrogen.
    const Vec3 out(s.atom(named("CA")).position.A.x > 0 ? 1 : -1, 0, 0);
    const auto passed = [&](const std::vector<std::string>& atoms, bool jabbing) {
      return passes(spec, s, atoms, out, jabbing);
    };
    CHECK(passed(round, false));
    CHECK_FALSE(passed(round, true));
    // A student who clicks the middle of the visible group, and a hand that moves from COO- to NH3+ first.
    CHECK_FALSE(passed({named("HA"), named("CA")}, false));
    for (const std::vector<const char*>& names : r.astray) {
      std::string reported;
      for (const char* name : names) reported += std::string(name) + " ";
      CAPTURE(reported);
      CHECK_FALSE(passed(all(names), false));
    }
  }
}
