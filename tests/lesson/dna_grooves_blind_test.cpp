// The program's lesson on the grooves of DNA: their depths, and what fits into which. What stands here is no fact of the
// lesson: facts know no axis from which or about which to measure, no number of places, and no set of all places that a
// task accepts.
#include <algorithm>

#include "tests/lesson/shipped_hand.h"
#include "tests/lesson/shipped_lesson.h"

using namespace moltact;
using namespace moltact::test;

namespace {

double fromAxis(const Vec3& p) { return std::hypot(p.x, p.y); }

double nearestToAxis(const std::vector<SurfacePlace>& places) {
  double least = 1e9;
  for (const SurfacePlace& p : places) least = std::min(least, fromAxis(p.scp_A));
  return least;
}

/// By how many degrees round the axis a place lies off the middle of the minor groove at its height. Each step of the
/// model turns by 36 degrees and rises by 3.38 A; the dyad through the minor groove's middle lies at 162 degrees.
double offMinorGroove_deg(const Vec3& p) {
  const double angle = std::atan2(p.y, p.x) * 180 / std::numbers::pi - 36.0 * p.z / 3.38 - 162.0;
  return angle - 360.0 * std::round(angle / 360.0);
}

/// Every place on these atoms where a probe can rest, on one atom alone or on two or three.
std::vector<SurfacePlace> everyPlace(const ShippedScene& dna, const std::string& text, double probe_A) {
  std::vector<SurfacePlace> out = dna.places(text, probe_A);
  const auto all = dna.select("all"), atoms = dna.select(text);
  for (const auto& more : {creasePlaces(dna.spheres, all, probe_A, 0.3), pitPlaces(dna.spheres, all, probe_A)})
    for (const SurfacePlace& p : more)
      if (std::any_of(p.atoms.begin(), p.atoms.end(), [&](std::int32_t a) {
            return a >= 0 && std::binary_search(atoms.begin(), atoms.end(), static_cast<std::uint32_t>(a));
          }))
        out.push_back(p);
  return out;
}

constexpr const char* kMinorFloor = "residue 5-8 and name C2 N3 O2 N2";
constexpr const char* kMajorFloor = "residue 5-8 and name N6 O4 N7";

}  // namespace

TEST_CASE(
    "dna-grooves-blind.md has 5 steps and 3 extra ones, a way to cross and one to trace, trials in the dark before and "
    "after, and two places to find in the dark") {
  const Lesson lesson = shippedLesson("dna-grooves-blind");
  checkCare(lesson);
  CHECK(lesson.steps.size() == 8);
  CHECK(std::count_if(lesson.steps.begin(), lesson.steps.end(), [](const Step& s) { return s.extra; }) == 3);
  CHECK(tasksOf(lesson, "trace") == 1);
  CHECK(tasksOf(lesson, "cross") == 1);
  CHECK(tasksOf(lesson, "same") == 2);
  CHECK(tasksOf(lesson, "find") == 2);
}

TEST_CASE(
    "a water-sized probe comes to 5 A from the axis in the minor groove, 4 A in the major one, and rests 13 A out on "
    "the ridge") {
  const ShippedScene dna("b-dna");
  CHECK(nearestToAxis(dna.places(kMinorFloor, 1.4)) == doctest::Approx(5).epsilon(0.1));
  CHECK(nearestToAxis(dna.places(kMajorFloor, 1.4)) == doctest::Approx(4).epsilon(0.1));
  double farthest = 0;
  for (const SurfacePlace& p : dna.places("residue 5-8 and name OP1", 1.4))
    farthest = std::max(farthest, fromAxis(p.scp_A));
  CHECK(farthest == doctest::Approx(13).epsilon(0.03));
}

TEST_CASE("a probe of 3 A comes to 6 A from the axis on the floor of the major groove") {
  const ShippedScene dna("b-dna");
  CHECK(nearestToAxis(dna.places(kMajorFloor, 3.0)) == doctest::Approx(6).epsilon(0.05));
}

TEST_CASE("the phosphates stand 73 degrees to either side of the middle of the minor groove") {
  const ShippedScene dna("b-dna");
  for (const std::uint32_t i : dna.select("name P"))
    CHECK(std::abs(offMinorGroove_deg(dna.molecule->spheres[i].centre_A)) == doctest::Approx(73).epsilon(0.01));
}

TEST_CASE(
    "the crossing of the minor groove cannot be done anywhere else: wherever a water-sized probe rests on its atoms it "
    "is between the ridges of the minor groove, on either strand's half") {
  const Lesson lesson = shippedLesson("dna-grooves-blind");
  const TaskSpec& task = taskOf(lesson, "the-minor-groove", "cross");
  const std::string line = "dna-grooves-blind.md:" + std::to_string(task.values["cross"].place.line);
  CAPTURE(line);
  const ShippedScene dna("b-dna");
  for (const char* side : {"cross", "to"}) {
    CAPTURE(side);
    const auto places = everyPlace(dna, task.values[side].selection.text(), 1.4);
    CHECK(places.size() > 500);
    double farthest_deg = 0;
    for (const SurfacePlace& p : places) farthest_deg = std::max(farthest_deg, std::abs(offMinorGroove_deg(p.scp_A)));
    CHECK(farthest_deg < 65);
  }
}

TEST_CASE(
    "the wall of the minor groove that is pressed with 3 A is met in the minor groove only, 9.5 A to 12.2 A from the "
    "axis; the atoms of a ridge do not count") {
  const std::string line = lineSaying("dna-grooves-blind", "it stays more than 9.5 Å away from it");
  CAPTURE(line);
  const Lesson lesson = shippedLesson("dna-grooves-blind");
  const TaskSpec& task = taskOf(lesson, "the-wider-finger-in-the-minor-groove", "press");
  const ShippedScene dna("b-dna");
  const auto places = everyPlace(dna, task.values["press"].selection.text(), 3.0);
  CHECK(places.size() > 100);
  for (const SurfacePlace& p : places) {
    CHECK(fromAxis(p.scp_A) > 9.5);
    CHECK(fromAxis(p.scp_A) < 12.2);
    CHECK(std::abs(offMinorGroove_deg(p.scp_A)) < 60);
  }
  const std::string ridge = lineSaying("dna-grooves-blind", "almost 13 Å (1.3 nm) from the axis");
  CAPTURE(ridge);
}

TEST_CASE(
    "thymine's methyl groups stand out into the major groove and are touched straight from outside, by a water-sized "
    "probe from more places than N6 or O4, which differ by 0.03 A only") {
  const std::string line = lineSaying("dna-grooves-blind", "This bump is what a hand can read of the bases");
  CAPTURE(line);
  const ShippedScene dna("b-dna");
  for (const char* residue : {"7", "8"}) {
    const std::string thymine = std::string("chain A and residue ") + residue + " and name ";
    CHECK(dna.openPlaces(thymine + "C7", 1.4) > 300);
    CHECK(dna.openPlaces(thymine + "C7", 1.4) > 2 * dna.openPlaces(thymine + "O4", 1.4));
    CHECK(fromAxis(dna.atom(thymine + "C7").position.A) > 2.0 + fromAxis(dna.atom(thymine + "O4").position.A));
    for (const SurfacePlace& p : dna.places(thymine + "C7", 1.4)) CHECK(std::abs(offMinorGroove_deg(p.scp_A)) > 73);
  }
  CHECK(1.7 * double(dna.openPlaces("chain A and residue 6 and name N6", 1.4)) <
        dna.openPlaces("chain A and residue 7 and name C7", 1.4));
}

TEST_CASE("what counts as found on the floor of one groove lies in that groove, not on a ridge and not in the other") {
  const Lesson lesson = shippedLesson("dna-grooves-blind");
  const auto at = lesson.find("find-the-narrow-one");
  REQUIRE(at);
  const auto& tasks = lesson.steps[*at].tasks;
  REQUIRE(tasks.size() == 2);
  const ShippedScene dna("b-dna");
  const auto surface = dna.places("residue 3-10", 1.4, 300);
  for (std::size_t k = 0; k < 2; ++k) {
    const auto floor = dna.select(tasks[k].values["find"].selection.text());
    const double within_A = tasks[k].values["within"].number;
    int right = 0;
    for (const SurfacePlace& p : surface) {
      const bool found = std::any_of(floor.begin(), floor.end(), [&](std::uint32_t i) {
        return glm::distance(p.scp_A, dna.spheres[i].centre_A) - dna.spheres[i].radius_A - 1.4 <= within_A;
      });
      if (!found) continue;
      ++right;
      CAPTURE(k);
      CAPTURE(p.scp_A.z);
      CHECK((std::abs(offMinorGroove_deg(p.scp_A)) < 73) == (k == 0));
    }
    CHECK(right > 20);
    CHECK(right < 0.5 * double(surface.size()));
  }
}

TEST_CASE("before the wider finger is felt the student predicts, and neither choice but the major groove is right") {
  const Lesson lesson = shippedLesson("dna-grooves-blind");
  const auto at = lesson.find("a-wider-finger");
  REQUIRE(at);
  const auto& questions = lesson.steps[*at].questions;
  REQUIRE(questions.size() == 1);
  CHECK(questions[0].prediction);
  REQUIRE(questions[0].choices.size() == 3);
  CHECK(questions[0].choices[0].right);
}
