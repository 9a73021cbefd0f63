// The program's lesson on the size of the probe: the gap closes at the stated size, and a sphere rests on both acids.
#include <algorithm>

#include "tests/lesson/shipped_lesson.h"

using namespace moltact;
using namespace moltact::test;

TEST_CASE(
    "the-probe-decides.md has 5 steps and 3 extra ones, with probes of 0, 0.2, 0.4, 1.4 and 3.5 A, a prediction, a "
    "largest probe to be "
    "found and eight trials in the dark of which seven must be right, 9 of 256 for a guesser") {
  const Lesson lesson = shippedLesson("the-probe-decides");
  checkCare(lesson);
  CHECK(lesson.steps.size() == 8);
  CHECK(tasksOf(lesson, "predict") == 1);
  CHECK(tasksOf(lesson, "same") == 2);
  CHECK(tasksOf(lesson, "fit") == 1);
  const std::string chance = lineSaying("the-probe-decides", "in 9 of 256 rounds, 3.5 %");
  CAPTURE(chance);
  for (const Step& s : lesson.steps)
    for (const TaskSpec& t : s.tasks)
      if (t.kind == "same") {
        CHECK(t.values["trials"].number == 8);
        if (t.values["asked"].text != "before") CHECK(t.values["right"].number == 7);
      }
  for (const double probe : {0.0, 0.2, 0.4, 1.4, 3.5}) {
    bool met = false;
    for (const Step& s : lesson.steps) met = met || s.scene.touch.probe_A == probe;
    CHECK_MESSAGE(met, probe);
  }
}

TEST_CASE(
    "the gap between three argon atoms closes at a probe of 0.29 A: below it a straight way leads through, above it a "
    "pit stops it") {
  const ShippedScene triangle("argon-triangle");
  const std::string says =
      linesSaying("the-probe-decides", {"The gap closes at 0.29 Å. Its middle is 2.17 Å",
                                        "- [x] Smaller, for the gap shrinks with the balls → Yes: 0.26 Å"});
  CAPTURE(says);
  const double gap_A = 3.76 / std::sqrt(3.0) - 1.88;
  CHECK(gap_A == doctest::Approx(0.29).epsilon(0.01));
  CHECK(3.76 / std::sqrt(3.0) == doctest::Approx(2.17).epsilon(0.001));
  CHECK(2 * 1.70 / std::sqrt(3.0) - 1.70 == doctest::Approx(0.26).epsilon(0.02));
  const auto all = triangle.select("all");
  CHECK(pitPlaces(triangle.spheres, all, gap_A - 0.01).empty());
  CHECK(pitPlaces(triangle.spheres, all, gap_A + 0.01).size() == 2);
  // At 0.2 A the whole crease between the two lower atoms is open, so 60 % of it can be traced, which is more than the
  // front half.
  const auto lower = triangle.select("atom 1 2");
  const double radius_A = std::sqrt(2.08 * 2.08 - 1.88 * 1.88);
  CHECK(double(creasePlaces(triangle.spheres, lower, 0.2, 0.05).size()) >= 2 * std::numbers::pi * radius_A / 0.05 - 1);
}

TEST_CASE(
    "a sphere of 3.5 A pushed into the middle of the cleft rests on Glu 35 and Asp 52 at once, straight from outside") {
  const ShippedScene lysozyme("1hel");
  const auto of = [&](const SurfacePlace& p, const std::string& text) {
    const auto atoms = lysozyme.select(text);
    return std::any_of(p.atoms.begin(), p.atoms.end(), [&](std::int32_t a) {
      return std::find(atoms.begin(), atoms.end(), static_cast<std::uint32_t>(a)) != atoms.end();
    });
  };
  const auto pits = pitPlaces(lysozyme.spheres, lysozyme.select("residue 35 44 52"), 3.5);
  CHECK(std::any_of(pits.begin(), pits.end(), [&](const SurfacePlace& p) {
    return of(p, "residue 35 and name OE1") && of(p, "residue 52 and name OD2") &&
           openFromOutside(lysozyme.spheres, p, 3.5);
  }));
}

TEST_CASE(
    "between argon atoms the excluded surface of a 1.4 A probe is round: the circle it rolls on is wider than it") {
  const std::string line = lineSaying("the-probe-decides", "- [x] The solvent-excluded surface");
  CAPTURE(line);
  // A probe that rolls in a crease whose circle is narrower than itself would cut its own side, and leave a cusp.
  const double circle_A = std::sqrt(3.28 * 3.28 - 1.88 * 1.88), pit_A = std::sqrt(3.28 * 3.28 - 3.76 * 3.76 / 3.0);
  CHECK(circle_A > 1.4);
  CHECK(pit_A > 1.4);
}
