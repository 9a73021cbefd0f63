// The shipped lesson on mirror images: which way round each form goes, how far its groups reach, and that hands that
// guess, jab or go the wrong way round do not pass.
#include <algorithm>

#include "tests/lesson/shipped_hand.h"

using namespace moltact;
using namespace moltact::test;

namespace {

constexpr const char* kLesson = "left-or-right";

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
    most = std::max(most, glm::distance(s.molecule->atoms[a].position.A, ca) + s.molecule->atoms[a].radius_A);
  return most;
}

}  // namespace

TEST_CASE(
    "left-or-right.md has 8 steps, six rounds to trace, two of them unseen, and six trials in the dark that must all "
    "be right") {
  const Lesson lesson = shippedLesson(kLesson);
  checkCare(lesson);
  CHECK(lesson.steps.size() == 8);
  CHECK(tasksOf(lesson, "trace") == 6);
  REQUIRE(tasksOf(lesson, "same") == 1);
  int unseen = 0;
  const ShippedScene phe("phenylalanine-pair");
  for (const Step& s : lesson.steps) unseen += s.scene.hide.given() && s.scene.hide.select(*phe.molecule).size() == 46;
  CHECK(unseen == 2);
  const std::string chance = lineSaying(kLesson, "gets there once in 64 rounds");
  CAPTURE(chance);
  for (const Step& s : lesson.steps)
    for (const TaskSpec& t : s.tasks)
      if (t.kind == "same") CHECK(t.values["trials"].number == t.values["right"].number);
}

TEST_CASE(
    "chain A of both pairs goes CO, R, N with the clock and is L; chain B is its mirror image, to 0.001 A, and goes "
    "against it") {
  const std::string with = lineSaying(kLesson, "- [x] As the hands of a clock"),
                    against = lineSaying(kLesson, "- [x] Against the hands of a clock");
  CAPTURE(with);
  CAPTURE(against);
  for (const char* name : {"alanine-pair", "phenylalanine-pair"}) {
    CAPTURE(name);
    const ShippedScene s(name);
    CHECK(handedness(s, "chain A") > 2.0);
    CHECK(handedness(s, "chain B") < -2.0);
    const auto l = s.select("chain A"), d = s.select("chain B");
    REQUIRE(l.size() == d.size());
    for (std::size_t k = 0; k < l.size(); ++k) {
      const Atom &a = s.molecule->atoms[l[k]], &b = s.molecule->atoms[d[k]];
      CHECK(a.name == b.name);
      CHECK(glm::distance(a.position.A * Vec3(-1, 1, 1), b.position.A) < 0.001);
    }
  }
}

TEST_CASE("from the middle carbon of alanine CH3 reaches 3.35 A, NH3+ 3.28 A and COO- 3.89 A") {
  const std::string line = lineSaying(kLesson, "reaches out 3.35 Å, NH₃⁺ 3.28 Å and COO⁻ 3.89 Å");
  CAPTURE(line);
  const ShippedScene s("alanine-pair");
  CHECK(s.select("chain A").size() == 13);
  CHECK(reach_A(s, "chain A and name HB1 HB2 HB3") == doctest::Approx(3.35).epsilon(0.002));
  CHECK(reach_A(s, "chain A and name H1 H2 H3") == doctest::Approx(3.28).epsilon(0.002));
  CHECK(reach_A(s, "chain A and name O OXT") == doctest::Approx(3.89).epsilon(0.002));
}

TEST_CASE(
    "turned to the front each form has its hydrogen toward the viewer, COO- above, and the ring at the right in L, at "
    "the left in D") {
  const std::string line = lineSaying(kLesson, "at the right it is L, and at the left it is D");
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

TEST_CASE("of ubiquitin's 76 amino acids 70 are L and six, all glycines, have no side chain") {
  const std::string told = lineSaying(kLesson, "all 70 amino acids of this protein"),
                    asked = lineSaying(kLesson, "has 76 amino acids. Six of them, all glycines");
  CAPTURE(told);
  CAPTURE(asked);
  const ShippedScene s("1ubq");
  CHECK(s.molecule->residues.size() == 76);
  int l = 0, none = 0;
  for (const Residue& r : s.molecule->residues) {
    const std::string of = "residue " + std::to_string(r.number);
    if (r.name == "GLY") {
      ++none;
      CHECK_FALSE(parseSelection(of + " and name CB")->select(*s.molecule).size());
    } else {
      l += handedness(s, of) > 1.5;
    }
  }
  CHECK(l == 70);
  CHECK(none == 6);
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
  for (const Atom& a : s.molecule->atoms) {
    low = glm::min(low, a.position.A);
    high = glm::max(high, a.position.A);
  }
  const Vec3 seen_from = glm::normalize(s.atom("residue 6 and name NZ").position.A - 0.5 * (low + high));
  CHECK(glm::dot(h, seen_from) > 0.99);
  for (const char* name : {"C O", "CB", "N"}) {
    CAPTURE(name);
    int open = 0;
    for (SurfacePlace p : s.places(std::string("residue 46 and name ") + name, 1.4)) {
      p.outward = h;
      open += openFromOutside(s.balls, p, 1.4);
    }
    CHECK(open > 20);
  }
}

TEST_CASE(
    "the rounds are passed by a hand that slides the right way round, by none that jabs the same atoms or goes the "
    "other way") {
  const Lesson lesson = shippedLesson(kLesson);
  struct Round {
    const char *step, *molecule, *chain, *side_chain;
  };
  for (const Round& r : {Round{"round-the-carbon", "alanine-pair", "chain A", "HB1"},
                         Round{"its-mirror-image", "alanine-pair", "chain B", "HB1"},
                         Round{"which-one-is-it", "phenylalanine-pair", "chain B", "CE1"}}) {
    CAPTURE(r.step);
    const ShippedScene s(r.molecule);
    const TaskSpec& spec = taskOf(lesson, r.step, "trace");
    const auto named = [&](const char* name) { return std::string(r.chain) + " and name " + name; };
    std::vector<std::string> round{named("OXT"), named(r.side_chain), named("HA"), named("H2")};
    // From the side of the hydrogen.
    const Vec3 out(s.atom(named("CA")).position.A.x > 0 ? 1 : -1, 0, 0);
    const auto passed = [&](const std::vector<std::string>& atoms, bool jabbing) {
      return passes(spec, s, atoms, out, jabbing);
    };
    CHECK(passed(round, false));
    CHECK_FALSE(passed(round, true));
    // A looker who clicks the middle of what he sees, and a hand that goes from COO- to NH3+ first.
    CHECK_FALSE(passed({named("HA"), named("CA")}, false));
    CHECK_FALSE(passed({named("OXT"), named("H2"), named("HA"), named(r.side_chain)}, false));
  }
}
