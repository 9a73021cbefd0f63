// The program's lesson on bonds and contacts: its depths and pits follow from the molecules' coordinates.
#include <algorithm>
#include <memory>

#include "engine/haptics/methods.h"
#include "tests/lesson/shipped_hand.h"

using namespace moltact;
using namespace moltact::test;

TEST_CASE(
    "bond-or-contact.md, also in German, has 6 steps and one extra step in 5 molecules, with a path "
    "around the ring, a pit to rest in, and a bond to distinguish from a contact in the dark") {
  for (const char* file : {"bond-or-contact", "bond-or-contact.de"}) {
    CAPTURE(file);
    const Lesson lesson = shippedLesson(file);
    checkCare(lesson);
    CHECK(lesson.steps.size() == 7);
    CHECK(std::count_if(lesson.steps.begin(), lesson.steps.end(), [](const Step& s) { return s.extra; }) == 1);
    CHECK(lesson.molecules.size() == 5);
    CHECK(tasksOf(lesson, "same") == 1);
    CHECK(tasksOf(lesson, "trace") == 1);
  }
}

TEST_CASE("two hydrogens that just touch turn the force by 55 degrees") {
  const std::string touching = lineSaying("hydrogen-bonds", "Two that only lie side by side turn the force by 55°"),
                    model = lineSaying("bond-or-contact", "If it turns by 55° or more, they only lie side by side");
  CAPTURE(touching);
  CAPTURE(model);
  CHECK(2.0 * std::asin(1.20 / (1.20 + 1.4)) * 180 / std::numbers::pi == doctest::Approx(55).epsilon(0.002));
}

TEST_CASE(
    "a water-sized probe sinks in by 0.59 A between argon atoms and by 0.08 A at a C-C bond, a point by 0.73 A in the "
    "middle of the ring, which is shut to it") {
  const std::string line = lineSaying(
      "bond-or-contact", "on all six carbons at once (the line at the bottom names some of them), 0.73 Å lower");
  CAPTURE(line);
  const double grown = 1.88 + 1.4, carbon = 1.70 + 1.4;
  CHECK(grown - std::sqrt(grown * grown - 1.88 * 1.88) == doctest::Approx(0.59).epsilon(0.01));
  CHECK(carbon - std::sqrt(carbon * carbon - 0.6985 * 0.6985) == doctest::Approx(0.08).epsilon(0.02));
  CHECK(1.70 - std::sqrt(1.70 * 1.70 - 1.397 * 1.397) == doctest::Approx(0.73).epsilon(0.01));
  // The middle of the ring is closed to a probe of any size.
  const ShippedScene benzene("benzene");
  for (int k = 0; k < 6; ++k)
    CHECK(glm::length(benzene.molecule->spheres[static_cast<std::size_t>(k)].centre_A) < 1.70);
  // Every pit of carbons is the one in the middle, where all six hold the point.
  const auto pits = pitPlaces(benzene.spheres, benzene.select("element C"), 0.0);
  CHECK(pits.size() >= 2);
  for (const SurfacePlace& p : pits) {
    CHECK(std::hypot(p.scp_A.x, p.scp_A.y) < 0.01);
    for (int k = 0; k < 6; ++k)
      CHECK(glm::distance(p.scp_A, benzene.spheres[static_cast<std::size_t>(k)].centre_A) ==
            doctest::Approx(1.70).epsilon(0.003));
  }
}

TEST_CASE(
    "pushed 0.55 A deep beside the middle of the ring, by up to 0.5 A to any side, the lesson's point settles in the "
    "pit; a water-sized probe did so within 0.1 A only") {
  const ShippedScene benzene("benzene");
  const auto spheres = std::make_shared<const SphereGrid>(benzene.molecule->spheres);
  const auto settles = [&](double probe_A, double aside_A) {
    const double pit_A = std::sqrt((1.70 + probe_A) * (1.70 + probe_A) - 1.397 * 1.397);
    int in_pit = 0;
    for (int k = 0; k < 24; ++k) {
      const auto exact = findMethod("exact")->make(spheres, probe_A);
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
    "pressed where the lesson sends the hand in the dark, the probe lies in the crease of the water's bond or in that "
    "of the argon atoms; the bond turns the force by 19 degrees and the contact by 70") {
  const Lesson lesson = shippedLesson("bond-or-contact");
  const TaskSpec& same = taskOf(lesson, "bond-or-contact-eyes-closed", "same");
  const ShippedScene s("water-and-argon");
  const auto bond = s.select(same.values["same"].selection.text()),
             contact = s.select(same.values["place"].selection.text());
  REQUIRE(bond.size() == 2);
  REQUIRE(contact.size() == 2);
  const auto turn_deg = [&](const std::vector<std::uint32_t>& pair) {
    const Sphere a = s.spheres[pair[0]], b = s.spheres[pair[1]];
    const double one = a.radius_A + 1.4, other = b.radius_A + 1.4, apart = glm::distance(a.centre_A, b.centre_A);
    return std::acos((one * one + other * other - apart * apart) / (2 * one * other)) * 180 / std::numbers::pi;
  };
  CHECK(turn_deg(bond) == doctest::Approx(19).epsilon(0.02));
  CHECK(turn_deg(contact) == doctest::Approx(70).epsilon(0.007));
  // Each is open from the side to which the task turns it: away from the middle between the two pairs.
  for (const auto& pair : {bond, contact}) {
    const Vec3 middle = 0.5 * (s.spheres[pair[0]].centre_A + s.spheres[pair[1]].centre_A);
    const double side = middle.x < 0 ? -1.0 : 1.0;
    int in_crease = 0;
    for (const double along_A : {-0.3, 0.01, 0.3})
      for (double up_A = -0.6; up_A <= 0.6; up_A += 0.01) {
        const auto exact = findMethod("exact")->make(std::make_shared<const SphereGrid>(s.molecule->spheres), 1.4);
        Contact felt;
        for (double x = 11.0; x > 7.6; x -= 0.02) felt = exact->step({Vec3(side * x, middle.y + up_A, along_A)});
        in_crease += felt.feature == Feature::Circle && felt.atoms[0] == std::int32_t(std::min(pair[0], pair[1])) &&
                     felt.atoms[1] == std::int32_t(std::max(pair[0], pair[1]));
      }
    CHECK(in_crease > 0);
  }
}
