// The shipped lesson on the size of the probe: the gap closes where it says, and the floor of the cleft is out of
// reach.
#include "tests/lesson/shipped_lesson.h"

using namespace moltact;
using namespace moltact::test;

TEST_CASE(
    "the-probe-decides.md has 7 steps, with probes of 0, 0.2, 0.4, 1.4 and 3 A, a prediction and trials in the dark") {
  const Lesson lesson = shippedLesson("the-probe-decides");
  checkCare(lesson);
  CHECK(lesson.steps.size() == 7);
  CHECK(tasksOf(lesson, "predict") == 1);
  CHECK(tasksOf(lesson, "same") == 1);
  for (const double probe : {0.0, 0.2, 0.4, 1.4, 3.0}) {
    bool met = false;
    for (const Step& s : lesson.steps) met = met || s.scene.touch.probe_A == probe;
    CHECK_MESSAGE(met, probe);
  }
}

TEST_CASE(
    "the gap between three argon atoms closes at a probe of 0.29 A: below it a straight way leads through, above it a "
    "pit stops it") {
  const ShippedScene triangle("argon-triangle");
  const double gap_A = 3.76 / std::sqrt(3.0) - 1.88;
  CHECK(gap_A == doctest::Approx(0.29).epsilon(0.01));
  const auto all = triangle.select("all");
  CHECK(pitPlaces(triangle.balls, all, gap_A - 0.01).empty());
  CHECK(pitPlaces(triangle.balls, all, gap_A + 0.01).size() == 2);
  // At 0.2 A the whole crease between the two lower atoms is open, so 60 % of it can be traced, which is more than the
  // front half.
  const auto lower = triangle.select("atom 1 2");
  const double radius_A = std::sqrt(2.08 * 2.08 - 1.88 * 1.88);
  CHECK(double(creasePlaces(triangle.balls, lower, 0.2, 0.05).size()) >= 2 * std::numbers::pi * radius_A / 0.05 - 1);
}

TEST_CASE(
    "a probe of 1.4 A reaches Gln 57 on the floor of lysozyme's cleft straight from outside, one of 3 A rests on none "
    "of its atoms") {
  const ShippedScene lysozyme("1hel");
  CHECK(lysozyme.openPlaces("residue 57", 1.4) > 50);
  CHECK(lysozyme.places("residue 57", 3.0).empty());
  CHECK(lysozyme.openPlaces("within 9 Å of (residue 57)", 3.0) > 100);
}

TEST_CASE("of lysozyme's 1001 atoms a probe of 1.4 A can rest on about 560 from outside, one of 3 A on about 340") {
  // Here those in closed hollows count as well, which no probe from outside comes to: a few more.
  const ShippedScene lysozyme("1hel");
  for (const auto& [probe, told] : {std::pair{1.4, 560}, std::pair{3.0, 340}}) {
    int reached = 0;
    for (std::uint32_t i = 0; i < 1001; ++i) {
      const std::uint32_t one[] = {i};
      reached += !facePlaces(lysozyme.balls, one, probe, 2000).empty();
    }
    CHECK((reached > 0.98 * told && reached < 1.08 * told));
  }
}
