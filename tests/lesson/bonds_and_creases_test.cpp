// The shipped lesson on bonds: what it says of turns, depths and distances follows from the molecules' coordinates.
#include "tests/lesson/shipped_lesson.h"

using namespace moltact;
using namespace moltact::test;

TEST_CASE(
    "bonds-and-creases.md, and the same in German, has 6 steps in 4 molecules, with crossings, creases to trace and a "
    "pit to rest in") {
  for (const char* file : {"bonds-and-creases", "bonds-and-creases.de"}) {
    CAPTURE(file);
    const Lesson lesson = shippedLesson(file);
    checkCare(lesson);
    CHECK(lesson.steps.size() == 6);
    CHECK(lesson.molecules.size() == 4);
    CHECK(tasksOf(lesson, "cross") == 4);
    CHECK(tasksOf(lesson, "trace") == 2);
  }
}

TEST_CASE(
    "the force turns by 70 degrees between argon atoms, 19 at O-H, 26 at C-C of benzene, 57 between its hydrogens, 28 "
    "at CA-CB") {
  CHECK(ShippedScene("argon-pair").turn_deg("atom 0", "atom 1", 1.4) == doctest::Approx(70).epsilon(0.007));
  CHECK(ShippedScene("water").turn_deg("atom 0", "atom 1", 1.4) == doctest::Approx(19).epsilon(0.02));
  const ShippedScene benzene("benzene");
  CHECK(benzene.turn_deg("atom 0", "atom 1", 1.4) == doctest::Approx(26).epsilon(0.01));
  CHECK(benzene.turn_deg("atom 0", "atom 6", 1.4) == doctest::Approx(19.5).epsilon(0.01));
  CHECK(benzene.turn_deg("atom 6", "atom 7", 1.4) == doctest::Approx(57).epsilon(0.01));
  CHECK(ShippedScene("alpha-helix").turn_deg("residue 10 and name CA", "residue 10 and name CB", 1.4) ==
        doctest::Approx(28).epsilon(0.02));
}

TEST_CASE(
    "the probe sinks in by 0.59 A between argon atoms, by 0.08 A at a C-C bond and by 0.33 A in the middle of the "
    "ring") {
  const double grown = 1.88 + 1.4, carbon = 1.70 + 1.4;
  CHECK(grown - std::sqrt(grown * grown - 1.88 * 1.88) == doctest::Approx(0.59).epsilon(0.01));
  CHECK(carbon - std::sqrt(carbon * carbon - 0.6985 * 0.6985) == doctest::Approx(0.08).epsilon(0.02));
  CHECK(carbon - std::sqrt(carbon * carbon - 1.397 * 1.397) == doctest::Approx(0.33).epsilon(0.02));
  // The middle of the ring is closed to a probe of any size.
  const ShippedScene benzene("benzene");
  for (int k = 0; k < 6; ++k)
    CHECK(glm::length(benzene.molecule->atoms[static_cast<std::size_t>(k)].position.A) < 1.70);
}

TEST_CASE(
    "in the helix the peptide bond is 1.33 A, the hydrogen bond 2.88 A, and a water-sized probe reaches both ends of "
    "either") {
  const ShippedScene helix("alpha-helix");
  CHECK(helix.between("residue 10 and name C", "residue 11 and name N") == doctest::Approx(1.33).epsilon(0.002));
  CHECK(helix.between("residue 10 and name O", "residue 14 and name N") == doctest::Approx(2.88).epsilon(0.003));
  CHECK(helix.openPlaces("residue 10 and name C", 1.4) > 10);
  CHECK(helix.openPlaces("residue 11 and name N", 1.4) > 10);
  CHECK(helix.openPlaces("residue 10 and name O", 1.4) > 100);
  CHECK(double(helix.places("residue 10 and name CB", 1.4).size()) / 3000 == doctest::Approx(0.37).epsilon(0.03));
}
