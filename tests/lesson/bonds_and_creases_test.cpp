// The shipped lesson on bonds: what it says of turns, depths and distances follows from the molecules' coordinates.
#include "engine/haptics/methods.h"
#include "tests/lesson/shipped_lesson.h"

using namespace moltact;
using namespace moltact::test;

TEST_CASE(
    "bonds-and-creases.md, and the same in German, has 9 steps in 5 molecules, with crossings, creases to trace and a "
    "pit to rest in") {
  for (const char* file : {"bonds-and-creases", "bonds-and-creases.de"}) {
    CAPTURE(file);
    const Lesson lesson = shippedLesson(file);
    checkCare(lesson);
    CHECK(lesson.steps.size() == 9);
    CHECK(lesson.molecules.size() == 5);
    CHECK(tasksOf(lesson, "cross") == 6);
    CHECK(tasksOf(lesson, "same") == 1);
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

TEST_CASE("two hydrogens that just touch turn the force by 55 degrees") {
  const std::string touching = lineSaying("bonds-and-creases", "Two that only lie side by side turn the force by 55°"),
                    model = lineSaying("bonds-and-creases", "If it turns by 55° or more, they only lie side by side");
  CAPTURE(touching);
  CAPTURE(model);
  CHECK(2.0 * std::asin(1.20 / (1.20 + 1.4)) * 180 / std::numbers::pi == doctest::Approx(55).epsilon(0.002));
}

TEST_CASE("the turns hold for a probe of 1.4 A: for a point CA-CB turns the force by 53 degrees, for 3 A argon by 45") {
  const std::string says =
      linesSaying("bonds-and-creases", {"between two carbons turns the force by 53°", "turns it by 45° only"});
  CAPTURE(says);
  CHECK(ShippedScene("alpha-helix").turn_deg("residue 10 and name CA", "residue 10 and name CB", 0.0) ==
        doctest::Approx(53).epsilon(0.01));
  CHECK(ShippedScene("argon-pair").turn_deg("atom 0", "atom 1", 3.0) == doctest::Approx(45).epsilon(0.01));
}

TEST_CASE(
    "a water-sized probe sinks in by 0.59 A between argon atoms and by 0.08 A at a C-C bond, a point by 0.73 A in the "
    "middle of the ring, which is shut to it") {
  const std::string line = lineSaying(
      "bonds-and-creases", "on all six carbons at once (the line at the bottom names some of them), 0.73 Å lower");
  CAPTURE(line);
  const double grown = 1.88 + 1.4, carbon = 1.70 + 1.4;
  CHECK(grown - std::sqrt(grown * grown - 1.88 * 1.88) == doctest::Approx(0.59).epsilon(0.01));
  CHECK(carbon - std::sqrt(carbon * carbon - 0.6985 * 0.6985) == doctest::Approx(0.08).epsilon(0.02));
  CHECK(1.70 - std::sqrt(1.70 * 1.70 - 1.397 * 1.397) == doctest::Approx(0.73).epsilon(0.01));
  // The middle of the ring is closed to a probe of any size.
  const ShippedScene benzene("benzene");
  for (int k = 0; k < 6; ++k)
    CHECK(glm::length(benzene.molecule->atoms[static_cast<std::size_t>(k)].position.A) < 1.70);
  // Every pit of carbons is the one in the middle, where all six hold the point.
  const auto pits = pitPlaces(benzene.balls, benzene.select("element C"), 0.0);
  CHECK(pits.size() >= 2);
  for (const SurfacePlace& p : pits) {
    CHECK(std::hypot(p.scp_A.x, p.scp_A.y) < 0.01);
    for (int k = 0; k < 6; ++k)
      CHECK(glm::distance(p.scp_A, benzene.balls[static_cast<std::size_t>(k)].centre_A) ==
            doctest::Approx(1.70).epsilon(0.003));
  }
}

TEST_CASE(
    "pushed 0.55 A deep beside the middle of the ring, by up to 0.5 A to any side, the lesson's point settles in the "
    "pit; a water-sized probe did so within 0.1 A only") {
  const ShippedScene benzene("benzene");
  const auto balls = std::make_shared<const BallScene>(benzene.molecule->balls());
  const auto settles = [&](double probe_A, double aside_A) {
    const double pit_A = std::sqrt((1.70 + probe_A) * (1.70 + probe_A) - 1.397 * 1.397);
    int in_pit = 0;
    for (int k = 0; k < 24; ++k) {
      const auto exact = findMethod("exact")->make(balls, probe_A);
      // Off the lines of symmetry: the file's coordinates are rounded to 0.001 A, and so wide is the crease between two
      // pits that lie there.
      const double angle = 2 * std::numbers::pi * (k + 0.3) / 24;
      Contact contact;
      for (double z = pit_A + 2.0; z > pit_A - 0.55; z -= 0.002)
        contact = exact->step({Vec3(aside_A * std::cos(angle), aside_A * std::sin(angle), z)});
      in_pit += contact.feature == Feature::Point;
    }
    return in_pit;
  };
  CHECK(settles(0.0, 0.1) == 24);
  CHECK(settles(0.0, 0.5) == 24);
  CHECK(settles(1.4, 0.35) == 0);
}

TEST_CASE(
    "between two waters the hydrogen is 2.02 A from the other oxygen and overlaps it by 0.70 A: the force turns by 42 "
    "degrees, by 19 at the bond, by 70 at the contact of the argon atoms beside them") {
  const std::string says =
      linesSaying("bonds-and-creases",
                  {"They are 2.02 Å (0.202 nm) apart", "their balls overlap by 0.70 Å",
                   "19° in the bond, 42° here, 70° in a contact", "a bond, in which the balls overlap by 1.76 Å",
                   "oxygens 2.976 Å apart, the lower molecule's axis at 57°"});
  CAPTURE(says);
  const ShippedScene s("water-and-argon");
  const std::string giver = "chain A and residue 1 and name O", given = "chain A and residue 1 and name H1",
                    taker = "chain A and residue 2 and name O";
  CHECK(s.between(given, taker) == doctest::Approx(2.02).epsilon(0.002));
  CHECK(1.52 + 1.20 - s.between(given, taker) == doctest::Approx(0.70).epsilon(0.005));
  CHECK(1.52 + 1.20 - s.between(giver, given) == doctest::Approx(1.76).epsilon(0.005));
  CHECK(s.turn_deg(given, taker, 1.4) == doctest::Approx(42).epsilon(0.015));
  CHECK(s.turn_deg(giver, given, 1.4) == doctest::Approx(19).epsilon(0.02));
  CHECK(s.turn_deg("chain B and residue 1", "chain B and residue 2", 1.4) == doctest::Approx(70).epsilon(0.007));
  CHECK(s.between(giver, taker) == doctest::Approx(2.976).epsilon(0.0005));
  const Vec3 o = s.atom(taker).position.A, line = o - s.atom(giver).position.A,
             axis = 0.5 * (s.atom("residue 2 and name H1").position.A + s.atom("residue 2 and name H2").position.A) - o;
  CHECK(std::acos(glm::dot(glm::normalize(axis), glm::normalize(line))) * 180 / std::numbers::pi ==
        doctest::Approx(57).epsilon(0.005));
  // Straight between the oxygens; the free hydrogen and those of the other water lean to opposite sides.
  CHECK(s.between(giver, given) + s.between(given, taker) == doctest::Approx(s.between(giver, taker)).epsilon(1e-4));
  const Vec3 free = s.atom("chain A and residue 1 and name H2").position.A - s.atom(giver).position.A;
  const auto aside = [&](const Vec3& v) { return v - glm::normalize(line) * glm::dot(v, glm::normalize(line)); };
  CHECK(glm::dot(aside(free), aside(axis)) < 0);
}

TEST_CASE(
    "pressed in the middle of the view, where the lesson sends the hand in the dark, the probe comes to rest in the "
    "crease of the hydrogen bond or in that of the argon atoms, and slides along it by 0.5 A to either side; that of "
    "the "
    "hydrogen bond ends after 1 A on either side, at another hydrogen") {
  const std::string line = lineSaying("bonds-and-creases", "both creases run from left to right near the middle");
  CAPTURE(line);
  const ShippedScene s("water-and-argon");
  const auto balls = std::make_shared<const BallScene>(s.molecule->balls());
  const struct {
    double side;
    std::int32_t one, other;
  } pairs[] = {{-1, 1, 3}, {1, 6, 7}};
  for (const auto& pair : pairs)
    for (const double along_A : {-0.5, -0.25, 0.01, 0.25, 0.5}) {
      CAPTURE(pair.side);
      CAPTURE(along_A);
      const auto exact = findMethod("exact")->make(balls, 1.4);
      Contact contact;
      for (double x = 11.0; x > 7.6; x -= 0.002) contact = exact->step({Vec3(pair.side * x, -0.02, along_A)});
      CHECK(contact.feature == Feature::Circle);
      CHECK(contact.atoms == std::array<std::int32_t, 3>{pair.one, pair.other, -1});
    }
  const std::string end = lineSaying("bonds-and-creases", "their crease ends after 1 Å on either side");
  CAPTURE(end);
  for (const double way : {-1.0, 1.0}) {
    const auto exact = findMethod("exact")->make(balls, 1.4);
    Contact contact;
    for (double x = 11.0; x > 7.6; x -= 0.002) contact = exact->step({Vec3(-x, -0.02, 0.01)});
    double free_A = 0.0;
    for (double z = 0.01; std::abs(z) < 3.0 && contact.feature == Feature::Circle; z += way * 0.002) {
      contact = exact->step({Vec3(-7.6, -0.02, z)});
      free_A = std::abs(contact.scp.A.z);
    }
    CHECK(contact.feature == Feature::Point);
    CHECK(free_A == doctest::Approx(1.0).epsilon(0.05));
  }
}

TEST_CASE(
    "with its hydrogen 1.01 A from the nitrogen the hydrogen bond of the helix is 1.90 A long, 0.82 A shorter than "
    "two neighbours, and neither as short as a bond nor as long as a contact") {
  const std::string says = linesSaying(
      "bonds-and-creases",
      {"That hydrogen is 1.90 Å from the oxygen", "oxygen and nitrogen are 2.88 Å apart", "2.72 Å - 1.90 Å = 0.82 Å"});
  CAPTURE(says);
  const ShippedScene helix("alpha-helix");
  const Vec3 n = helix.atom("residue 14 and name N").position.A;
  const Vec3 out = -glm::normalize(glm::normalize(helix.atom("residue 13 and name C").position.A - n) +
                                   glm::normalize(helix.atom("residue 14 and name CA").position.A - n));
  const double to_oxygen_A = glm::distance(n + out * 1.01, helix.atom("residue 10 and name O").position.A);
  CHECK(to_oxygen_A == doctest::Approx(1.90).epsilon(0.003));
  CHECK(1.52 + 1.20 - to_oxygen_A == doctest::Approx(0.82).epsilon(0.006));
}

TEST_CASE(
    "in the helix the peptide bond is 1.33 A, the hydrogen bond 2.88 A, and a water-sized probe reaches both ends of "
    "either") {
  const ShippedScene helix("alpha-helix");
  CHECK(helix.between("residue 10 and name C", "residue 11 and name N") == doctest::Approx(1.33).epsilon(0.002));
  CHECK(helix.between("residue 10 and name O", "residue 14 and name N") == doctest::Approx(2.88).epsilon(0.003));
  const std::string share = lineSaying("bonds-and-creases", "chain's carbon it is 36 %");
  CAPTURE(share);
  CHECK(helix.openPlaces("residue 10 and name C", 1.4) > 10);
  CHECK(helix.openPlaces("residue 11 and name N", 1.4) > 10);
  CHECK(helix.openPlaces("residue 10 and name O", 1.4) > 100);
  CHECK(double(helix.places("residue 10 and name CB", 1.4).size()) / 3000 == doctest::Approx(0.364).epsilon(0.015));
}

TEST_CASE(
    "the rule has gaps: at a bond of 2.05 A between two sulphurs the force turns by 37 degrees, between the oxygen and "
    "the hydrogen of a hydrogen bond by 40, more than at bonds of light atoms, less than at contacts") {
  const std::string line = lineSaying("bonds-and-creases", "the force turns by 37° at a bond between two sulphurs");
  CAPTURE(line);
  const auto turn_deg = [](double one_A, double other_A, double apart_A) {
    const double a = one_A + 1.4, b = other_A + 1.4;
    return std::acos((a * a + b * b - apart_A * apart_A) / (2 * a * b)) * 180 / std::numbers::pi;
  };
  CHECK(turn_deg(1.80, 1.80, 2.05) == doctest::Approx(37).epsilon(0.015));
  CHECK(turn_deg(1.52, 1.20, 1.90) == doctest::Approx(40).epsilon(0.015));
}
