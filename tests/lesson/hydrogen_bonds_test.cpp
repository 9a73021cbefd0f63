// The program's lesson on hydrogen bonds: its angles and distances follow from the molecules' coordinates.
#include "engine/haptics/methods.h"
#include "tests/lesson/shipped_lesson.h"

using namespace moltact;
using namespace moltact::test;

TEST_CASE(
    "hydrogen-bonds.md, and the same in German, asks a dark task before and after with the same keys, in the core of 5 "
    "steps") {
  for (const char* file : {"hydrogen-bonds", "hydrogen-bonds.de"}) {
    CAPTURE(file);
    const Lesson lesson = shippedLesson(file);
    checkCare(lesson);
    CHECK(lesson.steps.size() == 5);
    CHECK(lesson.molecules.size() == 2);
    CHECK(tasksOf(lesson, "same") == 2);
    CHECK(tasksOf(lesson, "cross") == 3);
  }
}

TEST_CASE(
    "the axis of the lower water makes 57 degrees with the line of the oxygens, and its hydrogens lean away from the "
    "free one of the other") {
  SAYS(lineSaying("hydrogen-bonds", "oxygens 2.976 Å apart, the lower molecule's axis at 57°"));
  const ShippedScene s("water-and-argon");
  const std::string giver = "chain A and residue 1 and name O", taker = "chain A and residue 2 and name O";
  const Vec3 o = s.atom(taker).position.A, line = o - s.atom(giver).position.A,
             axis = 0.5 * (s.atom("residue 2 and name H1").position.A + s.atom("residue 2 and name H2").position.A) - o;
  CHECK(std::acos(glm::dot(glm::normalize(axis), glm::normalize(line))) * 180 / std::numbers::pi ==
        doctest::Approx(57).epsilon(0.005));
  // The free hydrogen and those of the other water lean to opposite sides.
  const Vec3 free = s.atom("chain A and residue 1 and name H2").position.A - s.atom(giver).position.A;
  const auto aside = [&](const Vec3& v) { return v - glm::normalize(line) * glm::dot(v, glm::normalize(line)); };
  CHECK(glm::dot(aside(free), aside(axis)) < 0);
}

TEST_CASE(
    "pressed in the middle of the view, where the lesson sends the hand in the dark, the probe comes to rest in the "
    "crease of the hydrogen bond or in that of the argon atoms, and slides along it by 0.5 A to either side; that of "
    "the "
    "hydrogen bond ends after 1 A on either side, at another hydrogen") {
  const std::string line = lineSaying("hydrogen-bonds", "both creases run from left to right near the middle");
  CAPTURE(line);
  const ShippedScene s("water-and-argon");
  const auto spheres = std::make_shared<const SphereGrid>(s.molecule->spheres);
  const struct {
    double side;
    std::int32_t one, other;
  } pairs[] = {{-1, 1, 3}, {1, 6, 7}};
  for (const auto& pair : pairs)
    for (const double along_A : {-0.5, -0.25, 0.01, 0.25, 0.5}) {
      CAPTURE(pair.side);
      CAPTURE(along_A);
      const auto exact = findMethod("exact")->make(spheres, 1.4);
      Contact contact;
      for (double x = 11.0; x > 7.6; x -= 0.002) contact = exact->step({Vec3(pair.side * x, -0.02, along_A)});
      CHECK(contact.feature == Feature::Circle);
      CHECK(contact.atoms == std::array<std::int32_t, 3>{pair.one, pair.other, -1});
    }
  const std::string end = lineSaying("hydrogen-bonds", "their crease ends after 1 Å on either side");
  CAPTURE(end);
  for (const double way : {-1.0, 1.0}) {
    const auto exact = findMethod("exact")->make(spheres, 1.4);
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
      "hydrogen-bonds",
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
    "the rule has gaps: at a bond of 2.05 A between two sulphurs the force turns by 37 degrees, between the oxygen and "
    "the hydrogen of a hydrogen bond by 40, more than at bonds of light atoms, less than at contacts") {
  const std::string line = lineSaying("bond-or-contact", "the force turns by 37° at a bond between two sulphurs");
  CAPTURE(line);
  const auto turn_deg = [](double one_A, double other_A, double grid_spacing_A) {
    const double a = one_A + 1.4, b = other_A + 1.4;
    return std::acos((a * a + b * b - grid_spacing_A * grid_spacing_A) / (2 * a * b)) * 180 / std::numbers::pi;
  };
  CHECK(turn_deg(1.80, 1.80, 2.05) == doctest::Approx(37).epsilon(0.015));
  CHECK(turn_deg(1.52, 1.20, 1.90) == doctest::Approx(40).epsilon(0.015));
}
