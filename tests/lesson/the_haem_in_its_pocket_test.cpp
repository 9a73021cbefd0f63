// The program's lesson on the haem's pocket: from which side its irons are touched, and where its tasks count.
#include <algorithm>

#include "engine/lesson/passable.h"
#include "engine/lesson/tasks/touch_limits.h"
#include "tests/lesson/shipped_hand.h"

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
    "the-haem-in-its-pocket.md has 5 steps and one extra step in the whole molecule and in two cut-open pockets, with "
    "a "
    "search in the dark and a largest probe") {
  for (const char* file : {"the-haem-in-its-pocket", "the-haem-in-its-pocket.de"}) {
    CAPTURE(file);
    const Lesson lesson = shippedLesson(file);
    checkCare(lesson);
    CHECK(lesson.steps.size() == 6);
    CHECK(std::count_if(lesson.steps.begin(), lesson.steps.end(), [](const Step& s) { return s.extra; }) == 1);
    CHECK(tasksOf(lesson, "fit") == 1);
    CHECK(tasksOf(lesson, "find") == 1);
    CHECK(lesson.molecules.size() == 3);
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
  // What the task finds: the limit on the side of the valine and the distal histidine.
  const Lesson lesson = shippedLesson("the-haem-in-its-pocket");
  const TaskSpec& fit = taskOf(lesson, "a-smaller-visitor", "fit");
  const TouchLimits above(fit, "fit", *beta.molecule);
  const auto iron = beta.select(fit.values["fit"].selection.text());
  const auto limit = largestProbe(fit.values["least"].number, fit.values["most"].number, [&](double probe_A) {
    return !reachablePlaces(beta.spheres, iron, probe_A, true, [&](const SurfacePlace& p) {
              return above.allow(p.scp_A, probe_A);
            }).empty();
  });
  REQUIRE(limit);
  CHECK(*limit == doctest::Approx(1.0).epsilon(0.05));
  // From below nothing of 1.4 A comes to the iron.
  CHECK(alpha.places("element Fe", 1.4).size() == fromAbove(alpha, 1.4));
}

TEST_CASE(
    "the iron of the beta pocket can be touched from below with 0.6 A as well; the task that asks for it from above "
    "begins on atoms that meet the iron above the ring only") {
  const Lesson lesson = shippedLesson("the-haem-in-its-pocket");
  const auto at = lesson.find("a-smaller-visitor");
  REQUIRE(at);
  const TaskSpec& task = lesson.steps[*at].tasks.at(0);
  REQUIRE(task.kind == "cross");
  const std::string line = "the-haem-in-its-pocket.md:" + std::to_string(task.values["cross"].place.line);
  CAPTURE(line);
  const ShippedScene beta("haem-beta");
  const Vec3 up(0, std::sqrt(0.75), 0.5);
  const auto from = beta.select(task.values["cross"].selection.text()),
             iron = beta.select(task.values["to"].selection.text());
  REQUIRE(iron.size() == 1);
  const auto is = [](const std::vector<std::uint32_t>& atoms, std::int32_t a) {
    return std::find(atoms.begin(), atoms.end(), static_cast<std::uint32_t>(a)) != atoms.end();
  };
  // Were it enough to touch the iron, most of the ways to it would be the wrong ones.
  CHECK(beta.places("element Fe", 0.6).size() > 2 * fromAbove(beta, 0.6));
  // The hand touches the iron alone only after it has touched the iron and a residue at once.
  std::vector<std::uint32_t> both = from;
  both.push_back(iron[0]);
  int above = 0;
  for (const SurfacePlace& p : creasePlaces(beta.spheres, both, 0.6, 0.02)) {
    if (!is(iron, p.atoms[0]) && !is(iron, p.atoms[1])) continue;
    CHECK(glm::dot(p.scp_A - beta.spheres[iron[0]].centre_A, up) > 1.0);
    ++above;
  }
  CHECK(above > 10);
  // The faces of the iron above and below the ring are separate: no slide on the iron alone connects them.
  for (const SurfacePlace& p : beta.places("element Fe", 0.6, 20'000)) CHECK(std::abs(glm::dot(p.outward, up)) > 0.2);
}

TEST_CASE(
    "the iron of the alpha pocket is met with 1.4 A between the distal histidine and the valine, from above only") {
  const ShippedScene alpha("haem-alpha");
  CHECK(alpha.places("element Fe", 1.4, 20'000).size() > 50);
  for (const SurfacePlace& p : alpha.places("element Fe", 1.4, 20'000))
    CHECK(glm::dot(p.outward, Vec3(0, std::sqrt(0.75), 0.5)) > 0);
}

TEST_CASE(
    "the haem to be found in the dark does not lie in the middle of the view, and 1 in 20 places on the side that the "
    "student sees counts as found, or fewer") {
  const Lesson lesson = shippedLesson("the-haem-in-its-pocket");
  const auto at = lesson.find("find-a-haem-in-the-dark");
  REQUIRE(at);
  const Step& step = lesson.steps[*at];
  const TaskSpec& task = step.tasks.at(0);
  REQUIRE(task.kind == "find");
  CHECK_FALSE(step.scene.highlight.given());
  const ShippedScene whole("2hhb");
  Vec3 middle(0.0), ahead(0.0);
  for (const Sphere& a : whole.molecule->spheres) middle += a.centre_A / double(whole.molecule->atoms.size());
  const auto faced = step.scene.view.facing.select(*whole.molecule);
  for (const auto i : faced) ahead += whole.molecule->spheres[i].centre_A / double(faced.size());
  const Vec3 to_eye = glm::normalize(ahead - middle);
  const auto target = whole.select(task.values["find"].selection.text());
  const double within_A = task.values["within"].number;
  const double probe_A = step.scene.touch.probe_A;
  int seen = 0, right = 0;
  double nearest_A = 1e9;
  for (const SurfacePlace& p : whole.places("all", probe_A, 40)) {
    if (glm::dot(p.outward, to_eye) < 0.3 ||
        !openFromOutside(whole.spheres, {p.scp_A, to_eye, p.atoms, p.feature}, probe_A))
      continue;
    ++seen;
    if (std::none_of(target.begin(), target.end(), [&](std::uint32_t i) {
          return glm::distance(p.scp_A, whole.spheres[i].centre_A) - whole.spheres[i].radius_A - probe_A <= within_A;
        }))
      continue;
    ++right;
    const Vec3 off = p.scp_A - middle;
    nearest_A = std::min(nearest_A, glm::length(off - to_eye * glm::dot(off, to_eye)));
  }
  CAPTURE(seen);
  CAPTURE(right);
  CHECK(right > 5);
  CHECK(right * 20 < seen);
  CHECK(nearest_A > 5.0);
}
