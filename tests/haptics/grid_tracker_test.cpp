// The god-object on a signed-distance grid: the field against the distance itself, the SCP against closed forms and the
// oracle, and the failures caused by the grid spacing.
#include "engine/haptics/grid/grid_tracker.h"

#include <doctest/doctest.h>

#include <cmath>

#include "tests/haptics/judge.h"
#include "tests/haptics/walk.h"

using namespace moltact;
using test::makeScene;
using test::walkTo;

namespace {

constexpr double kSpacings[] = {0.2, 0.4, 0.8};

double distanceTo(const std::vector<Sphere>& spheres, const Vec3& p) {
  double least = 1e300;
  for (const Sphere& b : spheres) least = std::min(least, glm::distance(p, b.centre_A) - b.radius_A);
  return least;
}

}  // namespace

TEST_CASE("aaaround one sphere the field is the distance but for an error that falls by 8 with half the spacing") {
  const std::vector<Sphere> spheres{{{0.1, 0.2, 0.3}, 1.6}};
  double before = 0;
  for (const double spacing : {0.8, 0.4, 0.2, 0.1}) {
    CAPTURE(spacing);
    DistanceBricks bricks(makeScene(spheres), Vec3(0.0), spacing, 4.0);
    scenes::Random random(2);
    double sum2 = 0;
    for (int k = 0; k < 2000; ++k) {
      const Vec3 p = Vec3(0.1, 0.2, 0.3) + random.direction() * random.uniform(2.6, 3.4);
      DistanceBricks::Sample s{};
      int fills = 1;
      REQUIRE(bricks.sample(p, s, fills));
      const double off = s.value - distanceTo(spheres, p);
      sum2 += off * off;
    }
    const double rms = std::sqrt(sum2 / 2000);
    if (before > 0) CHECK((before / rms > 6.0 && before / rms < 14.0));
    before = rms;
  }
  CHECK(before < 3e-5);
}

TEST_CASE("the field's gradient and second derivatives are those of its values, by differences") {
  const scenes::Scene scene = scenes::cluster(20, 2);
  DistanceBricks bricks(makeScene(scene.spheres), Vec3(0.0), 0.4, 4.0);
  scenes::Random random(6);
  for (int k = 0; k < 200; ++k) {
    const Vec3 p(random.uniform(-2, 8), random.uniform(-2, 8), random.uniform(-2, 8));
    const double step = 1e-5;
    DistanceBricks::Sample s{}, up{}, down{};
    int fills = 99;
    REQUIRE(bricks.sample(p, s, fills));
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 d(0.0);
      d[axis] = step;
      REQUIRE(bricks.sample(p + d, up, fills));
      REQUIRE(bricks.sample(p - d, down, fills));
      CHECK(s.gradient[axis] == doctest::Approx((up.value - down.value) / (2 * step)).epsilon(1e-4));
      const Vec3 second = (up.gradient - down.gradient) / (2 * step);
      for (int other = 0; other < 3; ++other) {
        const bool across_cells = glm::floor((p + d) / 0.4 + 0.5) != glm::floor((p - d) / 0.4 + 0.5);
        if (!across_cells) CHECK(std::abs(s.hessian[axis][other] - second[other]) <= 1e-5);
      }
    }
  }
}

TEST_CASE("from brick to brick and cell to cell value and gradient are continuous to 1e-9") {
  const scenes::Scene scene = scenes::pit();
  DistanceBricks bricks(makeScene(scene.spheres), Vec3(0.0), 0.4, 4.0);
  scenes::Random random(1);
  for (int k = 0; k < 300; ++k) {
    Vec3 p(random.uniform(-3, 5), random.uniform(-3, 5), random.uniform(-3, 3));
    const int axis = k % 3;
    p[axis] = 0.4 * (std::round(p[axis] / 0.4) + 0.5);  // on a border of cells; one in four is a border of bricks
    Vec3 a = p, b = p;
    a[axis] -= 1e-12;
    b[axis] += 1e-12;
    DistanceBricks::Sample low{}, high{};
    int fills = 9;
    REQUIRE(bricks.sample(a, low, fills));
    REQUIRE(bricks.sample(b, high, fills));
    CHECK(std::abs(low.value - high.value) <= 1e-9);
    CHECK(glm::distance(low.gradient, high.gradient) <= 1e-9);
  }
}

TEST_CASE("a brick is made once, named spheres are counted once, and without leave to make one nothing is read") {
  DistanceBricks bricks(makeScene({{{0, 0, 0}, 1.6}, {{2, 0, 0}, 1.6}}), Vec3(0.0), 0.4, 4.0);
  DistanceBricks::Sample s{};
  int none = 0, one = 1;
  CHECK_FALSE(bricks.sample({3, 0, 0}, s, none));
  CHECK(bricks.bricksMade() == 0);
  CHECK(bricks.sample({3, 0, 0}, s, one));
  CHECK(one == 0);
  CHECK(bricks.sample({3, 0, 0}, s, none));
  CHECK(bricks.bricksMade() == 1);
  CHECK(bricks.nearestSphere({3, 0, 0}) == 1);
  CHECK(bricks.spheresRemembered() >= 1);
  CHECK(bricks.spheresRemembered() <= 2);
  bricks.setCap(9.0);
  CHECK(bricks.spheresRemembered() == 0);
}

TEST_CASE(
    "on one sphere of 3 A the SCP is off by less than 0.0005, 0.002 and 0.01 A at spacings of 0.2, 0.4 and 0.8 "
    "A") {
  const double limits[] = {0.0005, 0.002, 0.01};
  for (int k = 0; k < 3; ++k) {
    CAPTURE(kSpacings[k]);
    GridTracker tracker(makeScene({{{0, 0, 0}, 1.6}}), 1.4, kSpacings[k]);
    tracker.step({{0, 0, 5}});
    scenes::Random random(9);
    Vec3 u(0, 0, 1);
    double worst = 0;
    for (int tick = 0; tick < 3000; ++tick) {
      u = glm::normalize(u + 0.01 * random.direction());
      const Contact c = tracker.step({2.4 * u});
      REQUIRE(c.feature == Feature::Sphere);
      REQUIRE(c.atoms[0] == 0);
      worst = std::max(worst, glm::distance(c.scp.A, 3.0 * u));
    }
    CHECK(worst <= limits[k]);
    CHECK(tracker.cutShort() == 0);
  }
}

TEST_CASE(
    "walking over every scene no contact is lost at 0.2 A, and the SCP is off by less than 0.05 A in half of "
    "all ticks") {
  std::uint64_t seed = 500;
  for (const scenes::Scene& scene : scenes::all()) {
    CAPTURE(scene.name);
    CAPTURE(seed);
    GridTracker tracker(makeScene(scene.spheres), scene.probe_A, 0.2);
    const test::Judged judged = test::judge(tracker, scene, scenes::walk(scene, 1000, seed++));
    CHECK(judged.both > 700);
    CHECK(judged.lost <= 3);
    CHECK(judged.off(0.5) <= 0.05);
    CHECK(judged.deepest_A <= 0.05);
  }
}

TEST_CASE(
    "known failure: in a crease of two spheres the SCP floats above it by a share of the spacing, and the more "
    "the wider that is") {
  const double height = std::sqrt(8.0);
  double before = 0;
  for (const double spacing : kSpacings) {
    CAPTURE(spacing);
    // Off the grid's own planes, so that no symmetry helps.
    const Vec3 off(0.13, 0.07, 0.05);
    GridTracker tracker(makeScene({{Vec3(-1, 0, 0) + off, 1.6}, {Vec3(1, 0, 0) + off, 1.6}}), 1.4, spacing);
    const Contact c = walkTo(tracker, off + Vec3(0, 0, 6), off + Vec3(0, 0, 2), 0.02);
    const double floats = glm::distance(c.scp.A - off, {0, 0, height});
    CHECK(floats > 0.01 * spacing);
    CHECK(floats < 0.3 * spacing);
    CHECK(floats > before);
    before = floats;
  }
}

TEST_CASE("known failure: a ring whose hole is 0.05 A too large for the probe is closed at a spacing of 0.8 A") {
  const scenes::Scene scene = scenes::ring(6, 0.05);
  GridTracker coarse(makeScene(scene.spheres), scene.probe_A, 0.8);
  const Contact c = walkTo(coarse, {0.01, 0.02, 6}, {0.01, 0.02, -4}, 0.02);
  CHECK(c.touching());
  CHECK(c.scp.A.z > 0);
}

TEST_CASE("another probe feels another level of the same field: no brick is made for the places already known") {
  GridTracker tracker(makeScene({{{0, 0, 0}, 1.6}}), 1.4, 0.4);
  walkTo(tracker, {0.1, 0.2, 6}, {0.1, 0.2, 2}, 0.02);
  const std::uint64_t made = tracker.bricksMade();
  const Vec3 up = glm::normalize(Vec3(0.1, 0.2, 2));
  for (const double probe : {1.9, 1.4, 1.2}) {
    CAPTURE(probe);
    tracker.setProbe(probe);
    CHECK(glm::distance(tracker.step({{0.1, 0.2, 2}}).scp.A, (1.6 + probe) * up) <= 0.002);
  }
  CHECK(tracker.bricksMade() <= made + 4);
}

TEST_CASE("ticks held still after a slide into a pit leave the SCP at rest to 1e-9 A") {
  for (const double spacing : kSpacings) {
    CAPTURE(spacing);
    const scenes::Scene scene = scenes::pit();
    GridTracker tracker(makeScene(scene.spheres), scene.probe_A, spacing);
    walkTo(tracker, {1.3, 0.7, 6}, {1.3, 0.7, 1.5}, 0.02);
    for (int k = 0; k < 5; ++k) tracker.step({{1.3, 0.7, 1.5}});
    const Vec3 rest = tracker.step({{1.3, 0.7, 1.5}}).scp.A;
    double moved = 0;
    for (int k = 0; k < 100; ++k) moved = std::max(moved, glm::distance(tracker.step({{1.3, 0.7, 1.5}}).scp.A, rest));
    CHECK(moved <= 1e-9);
  }
}

TEST_CASE(
    "passing through every scene at 0.05 to 12 A a tick, the SCP is never deeper than 0.1 A at 0.2 and 0.4 "
    "A, 0.2 A at 0.8 A") {
  std::uint64_t seed = 600;
  for (const scenes::Scene& scene : scenes::all()) {
    CAPTURE(scene.name);
    CAPTURE(seed);
    const scenes::Path path = scenes::passes(scene, 500, seed++);
    for (const double spacing : kSpacings) {
      CAPTURE(spacing);
      GridTracker tracker(makeScene(scene.spheres), scene.probe_A, spacing);
      double deepest = -1;
      for (const Vec3& hip : path)
        if (const Contact c = tracker.step({hip}); c.touching())
          deepest = std::max(deepest, test::deepest_A(scene.spheres, scene.probe_A, c.scp.A));
      CHECK(deepest <= (spacing > 0.5 ? 0.2 : 0.1));
    }
  }
}

TEST_CASE(
    "with a probe of 12 A over 3000 spheres the field at 0.4 A still is the distance to 0.01 A off the "
    "creases") {
  scenes::Random random(3);
  std::vector<Sphere> spheres;
  for (int k = 0; k < 3000; ++k)
    spheres.push_back({{random.uniform(-18, 18), random.uniform(-18, 18), random.uniform(-18, 18)}, 1.6});
  DistanceBricks bricks(makeScene(spheres), Vec3(0.0), 0.4, 15.0);
  int near = 0;
  for (int k = 0; k < 300; ++k) {
    const Vec3 p = 38.0 * random.direction();
    DistanceBricks::Sample s{};
    int fills = 1;
    REQUIRE(bricks.sample(p, s, fills));
    const double is = std::min(15.0, distanceTo(spheres, p));
    near += std::abs(s.value - is) <= 0.01;
    CHECK(std::abs(s.value - is) <= 0.2);
  }
  CHECK(near > 250);
}

TEST_CASE(
    "made beforehand, the grid leaves fewer than 1 in 100 of its bricks to be made on 3000 ticks over 50 spheres, and "
    "gives the same places") {
  const scenes::Scene scene = scenes::cluster(50, 3);
  const auto spheres = makeScene(scene.spheres);
  GridTracker ready(spheres, scene.probe_A, 0.4, true), lazy(spheres, scene.probe_A, 0.4);
  const std::uint64_t before = ready.bricksMade();
  double apart = 0;
  for (const Vec3& hip : scenes::walk(scene, 3000, 21))
    apart = std::max(apart, glm::distance(ready.step({hip}).scp.A, lazy.step({hip}).scp.A));
  CHECK(apart == 0.0);
  CHECK(lazy.bricksMade() > 20);
  CHECK(double(ready.bricksMade() - before) < 0.01 * double(before));
}
