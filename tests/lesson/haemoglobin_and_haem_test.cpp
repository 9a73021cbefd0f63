// The shipped lesson on haemoglobin: what it says of the iron's place, and of who can touch it, is so in the entry.
#include <algorithm>
#include <tuple>

#include "tests/lesson/shipped_lesson.h"

using namespace moltact;
using namespace moltact::test;

namespace {

/// Directions of 3000 from above in which a probe rests on the iron of a cut-open pocket.
std::size_t fromAbove(const ShippedScene& pocket, double probe_A) {
  const Vec3 up(0, std::sqrt(0.75), 0.5);
  const auto places = pocket.places("element Fe", probe_A);
  return static_cast<std::size_t>(
      std::count_if(places.begin(), places.end(), [&](const SurfacePlace& p) { return glm::dot(p.outward, up) > 0; }));
}

}  // namespace

TEST_CASE(
    "haemoglobin-and-haem.md has 8 steps in the whole molecule and in two cut-open pockets, with a search in the "
    "dark") {
  const Lesson lesson = shippedLesson("haemoglobin-and-haem");
  checkCare(lesson);
  CHECK(lesson.steps.size() == 8);
  CHECK(lesson.molecules.size() == 3);
  CHECK(tasksOf(lesson, "find") == 1);
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

TEST_CASE("the valine over the iron is 4.1 A from it in the beta pocket and 5.2 A in the alpha pocket") {
  CHECK(ShippedScene("haem-alpha").between("element Fe", "residue 62 and name CG2") ==
        doctest::Approx(5.2).epsilon(0.01));
  CHECK(ShippedScene("haem-beta").between("element Fe", "residue 67 and name CG2") ==
        doctest::Approx(4.1).epsilon(0.01));
}

TEST_CASE(
    "the entry has a water 3.4 A from the irons of both alpha chains, and none within 7 A of those of the beta "
    "chains") {
  const auto molecule = readMolecule(MOLTACT_SOURCE_DIR "/molecules/2hhb.pdb", {.waters = true});
  REQUIRE(molecule);
  for (const auto& [chain, least_A, most_A] : {std::tuple{"A", 3.35, 3.45}, std::tuple{"C", 3.35, 3.46},
                                               std::tuple{"B", 7.0, 20.0}, std::tuple{"D", 7.0, 20.0}}) {
    const auto iron = parseSelection(std::string("chain ") + chain + " and element Fe")->select(*molecule);
    REQUIRE(iron.size() == 1);
    double nearest_A = 1e9;
    for (const auto w : parseSelection("water")->select(*molecule))
      nearest_A =
          std::min(nearest_A, glm::distance(molecule->atoms[iron[0]].position.A, molecule->atoms[w].position.A));
    CAPTURE(chain);
    CHECK((nearest_A >= least_A && nearest_A <= most_A));
  }
}

TEST_CASE(
    "from above, the iron of the alpha pocket can be touched with 1.4 A; that of the beta pocket with 0.6 A and 0.9 A, "
    "but not with 1 A") {
  const ShippedScene alpha("haem-alpha"), beta("haem-beta");
  CHECK(fromAbove(alpha, 1.4) >= 10);
  CHECK(alpha.openPlaces("element Fe", 1.4) >= 5);
  CHECK(fromAbove(beta, 0.6) >= 15);
  CHECK(fromAbove(beta, 0.9) >= 1);
  CHECK(fromAbove(beta, 1.0) == 0);
  CHECK(beta.places("element Fe", 1.4).empty());
  // From below nothing of 1.4 A comes to the iron.
  CHECK(alpha.places("element Fe", 1.4).size() == fromAbove(alpha, 1.4));
}

TEST_CASE(
    "the irons of deoxyhaemoglobin lie 0.43 A to 0.56 A out of the plane of the ring, toward the proximal histidine") {
  const ShippedScene whole("2hhb");
  for (const char* chain : {"A", "B", "C", "D"}) {
    const std::string c = std::string("chain ") + chain + " and ";
    const auto core = whole.select(c +
                                   "resname HEM and (name \"N A\" \"N B\" \"N C\" \"N D\" CHA CHB CHC CHD C1A C2A C3A "
                                   "C4A C1B C2B C3B C4B C1C C2C C3C C4C C1D C2D C3D C4D)");
    REQUIRE(core.size() == 24);
    Vec3 middle(0.0);
    for (const auto i : core) middle += whole.molecule->atoms[i].position.A / 24.0;
    const auto at = [&](const char* name) {
      return whole.atom(c + "resname HEM and name \"" + name + "\"").position.A;
    };
    // From the normal of the four nitrogens down to the least squares.
    Vec3 normal = glm::normalize(glm::cross(at("N A") - at("N C"), at("N B") - at("N D")));
    for (int k = 0; k < 500; ++k) {
      Vec3 pull(0.0);
      for (const auto i : core) {
        const Vec3 q = whole.molecule->atoms[i].position.A - middle;
        pull += q * glm::dot(q, normal);
      }
      normal = glm::normalize(normal - 0.002 * pull);
    }
    const std::string proximal =
        std::string("resname HIS and name NE2 and residue ") + (chain[0] == 'A' || chain[0] == 'C' ? "87" : "92");
    if (glm::dot(whole.atom(c + proximal).position.A - middle, normal) < 0) normal = -normal;
    const double out = glm::dot(at("FE") - middle, normal);
    CAPTURE(chain);
    CHECK((out > 0.42 && out < 0.57));
  }
}
