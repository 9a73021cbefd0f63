// The exact tracker against closed forms: one sphere, a crease of two, a pit of three, and scenes where other methods
// fail. exact_against_oracle_test.cpp compares random scenes with an independent tracker.
#include "engine/haptics/exact/exact_tracker.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "tests/haptics/walk.h"

using namespace moltact;
using test::deepest_A;
using test::makeScene;
using test::walkTo;

namespace {

constexpr double kPi = 3.14159265358979323846;

void checkNear(const Vec3& a, const Vec3& b, double tolerance_A) {
  CAPTURE(a.x);
  CAPTURE(a.y);
  CAPTURE(a.z);
  CAPTURE(b.x);
  CAPTURE(b.y);
  CAPTURE(b.z);
  CHECK(glm::distance(a, b) <= tolerance_A);
}

}  // namespace

TEST_CASE("1 A deep in one sphere of 1.6 + 1.4 A the SCP lies 3 A from the centre, straight above the HIP") {
  ExactTracker tracker(makeScene({{{0, 0, 0}, 1.6}}), 1.4);
  CHECK(tracker.step({{0, 0, 5}}).feature == Feature::Free);
  const Contact c = tracker.step({{0, 1.2, 1.6}});  // 2 A from the centre
  CHECK(c.feature == Feature::Sphere);
  CHECK(c.atoms == std::array<std::int32_t, 3>{0, -1, -1});
  checkNear(c.scp.A, {0, 1.8, 2.4}, 1e-14);
}

TEST_CASE(
    "over 10 000 random places inside one sphere, met in small steps, the SCP is the radial projection to 1e-12 A") {
  ExactTracker tracker(makeScene({{{1, 2, 3}, 1.7}}), 1.4);
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  tracker.step({{1, 2, 9}});
  Vec3 h{1, 2, 5.5};
  double worst = 0;
  for (int k = 0; k < 10'000; ++k) {
    const Contact c = tracker.step({h});
    REQUIRE(c.feature == Feature::Sphere);
    const Vec3 m = h - Vec3(1, 2, 3);
    worst = std::max(worst, glm::distance(c.scp.A, Vec3(1, 2, 3) + m * (3.1 / glm::length(m))));
    h += 0.05 * Vec3(normal(random), normal(random), normal(random));
    const Vec3 next = h - Vec3(1, 2, 3);
    h = Vec3(1, 2, 3) + next * (std::clamp(glm::length(next), 0.5, 3.0) / glm::length(next));
  }
  CHECK(worst <= 1e-12);
}

TEST_CASE("pushed between two equal spheres 2 A apart the SCP lies on their circle of radius sqrt(8) A") {
  ExactTracker tracker(makeScene({{{-1, 0, 0}, 1.6}, {{1, 0, 0}, 1.6}}), 1.4);
  const Contact c = walkTo(tracker, {0, 0, 6}, {0.05, 0, 2.0}, 0.01);
  CHECK(c.feature == Feature::Circle);
  CHECK(c.atoms == std::array<std::int32_t, 3>{0, 1, -1});
  checkNear(c.scp.A, {0, 0, std::sqrt(8.0)}, 1e-13);
  SUBCASE("and follows the HIP round the bond by the same angle") {
    for (int k = 1; k <= 628; ++k) {
      const double t = 0.01 * k;
      const Contact round = tracker.step({{0.05, 2.0 * std::sin(t), 2.0 * std::cos(t)}});
      REQUIRE(round.feature == Feature::Circle);
      REQUIRE(glm::distance(round.scp.A, std::sqrt(8.0) * Vec3(0, std::sin(t), std::cos(t))) <= 1e-12);
    }
  }
  SUBCASE("and is released to the second sphere where the HIP leaves the triangle of the SCP and the two centres") {
    // At height z the triangle's edge to the second centre lies at x = 1 - z / sqrt(8).
    const double edge = 1.0 - 2.0 / std::sqrt(8.0);
    CHECK(walkTo(tracker, {0.05, 0, 2}, {edge - 1e-9, 0, 2}, 0.01).feature == Feature::Circle);
    const Contact out = tracker.step({{edge + 1e-9, 0, 2}});
    CHECK(out.feature == Feature::Sphere);
    CHECK(out.atoms[0] == 1);
  }
}

TEST_CASE("pushed into the pit of three spheres the SCP holds in the point that has the same distance from all three") {
  const double d = 2.0;
  const std::vector<Sphere> spheres{{{0, 0, 0}, 1.6}, {{d, 0, 0}, 1.6}, {{d / 2, d * std::sqrt(3.0) / 2, 0}, 1.6}};
  ExactTracker tracker(makeScene(spheres), 1.4);
  const Vec3 foot(d / 2, d * std::sqrt(3.0) / 6, 0);
  const double height = std::sqrt(9.0 - d * d / 3.0);
  const Contact c = walkTo(tracker, foot + Vec3(0.02, 0.01, 5), foot + Vec3(0.02, 0.01, 1.5), 0.02);
  CHECK(c.feature == Feature::Point);
  CHECK(c.atoms == std::array<std::int32_t, 3>{0, 1, 2});
  checkNear(c.scp.A, foot + Vec3(0, 0, height), 1e-13);
}

TEST_CASE("a HIP that starts inside gives no contact until it has been outside once") {
  ExactTracker tracker(makeScene({{{0, 0, 0}, 1.6}}), 1.4);
  for (int k = 0; k < 5; ++k) {
    const Contact c = tracker.step({{0, 0, 1.0 + 0.1 * k}});
    CHECK(c.fault == Fault::StartedInside);
    CHECK_FALSE(c.touching());
  }
  CHECK(tracker.step({{0, 0, 3.1}}).fault == Fault::None);
  CHECK(tracker.step({{0, 0, 2.5}}).touching());
}

TEST_CASE("NaN, infinity and places beyond 1e9 A are refused, and the contact continues from where it was") {
  ExactTracker tracker(makeScene({{{0, 0, 0}, 1.6}}), 1.4);
  walkTo(tracker, {0, 0, 5}, {0, 0, 2}, 0.1);
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  for (const Vec3& bad : {Vec3(nan, 0, 0), Vec3(0, inf, 0), Vec3(0, 0, -inf), Vec3(0, 2e9, 0)}) {
    const Contact c = tracker.step({bad});
    CHECK(c.fault == Fault::NotFinite);
    CHECK_FALSE(c.touching());
    CHECK(std::isfinite(c.scp.A.x + c.scp.A.y + c.scp.A.z));
  }
  checkNear(tracker.step({{0, 0.1, 2}}).scp.A, 3.0 * glm::normalize(Vec3(0, 0.1, 2)), 1e-13);
}

TEST_CASE("a HIP exactly on the centre, or on a circle's axis, leaves the SCP where it was") {
  ExactTracker one(makeScene({{{0, 0, 0}, 1.6}}), 1.4);
  walkTo(one, {0, 0, 5}, {0, 0, 0.5}, 0.1);
  checkNear(one.step({{0, 0, 0}}).scp.A, {0, 0, 3}, 1e-14);
  ExactTracker two(makeScene({{{-1, 0, 0}, 1.6}, {{1, 0, 0}, 1.6}}), 1.4);
  walkTo(two, {0, 0, 6}, {0, 0, 0.25}, 0.25);
  checkNear(two.step({{0, 0, 0}}).scp.A, {0, 0, std::sqrt(8.0)}, 1e-13);
}

TEST_CASE("passes of 0.05 to 12 A a tick straight through a row of spheres never put the SCP in one of them") {
  std::vector<Sphere> spheres;
  for (int k = 0; k < 8; ++k) spheres.push_back({{0, 0, 2.5 * k}, 1.6});
  for (const double step : {0.05, 0.3, 1.0, 3.0, 6.0, 12.0}) {
    CAPTURE(step);
    ExactTracker tracker(makeScene(spheres), 1.4);
    for (double x = -30; x < 30; x += step) {
      const Contact c = tracker.step({{x, 0.3, 8.1}});
      CHECK(deepest_A(spheres, 1.4, c.scp.A) <= 1e-12);
      if (std::abs(x) < 2.0 && x > -29) CHECK(c.touching());
    }
  }
}

TEST_CASE("a path of a million angstroms in one tick meets the only sphere on it") {
  ExactTracker tracker(makeScene({{{0, 0, 0}, 1.6}}), 1.4);
  tracker.step({{-1e6, 0.5, 0}});
  const Contact c = tracker.step({{1.0, 0.5, 0}});
  CHECK(c.feature == Feature::Sphere);
  CHECK(deepest_A({{{0, 0, 0}, 1.6}}, 1.4, c.scp.A) <= 1e-12);
}

TEST_CASE("two spheres a billion angstroms apart: the way from one to the other is found in one look at both") {
  const std::vector<Sphere> spheres{{{-5e8, 0, 0}, 1.6}, {{5e8, 0, 0}, 1.6}};
  ExactTracker tracker(makeScene(spheres), 1.4);
  tracker.step({{-5e8 + 10, 0, 0}});
  const Contact c = tracker.step({{5e8, 0, 0}});
  CHECK(c.feature == Feature::Sphere);
  CHECK(c.atoms[0] == 1);
  CHECK(c.scp.A.x == doctest::Approx(5e8 - 3).epsilon(1e-14));
}

TEST_CASE(
    "a ring of 12 spheres with a hole 0.1 A smaller than the probe holds it above, 0.1 A larger lets it through") {
  for (const double gap : {-0.1, 0.1}) {
    CAPTURE(gap);
    std::vector<Sphere> spheres;  // the hole's radius is ring - 1.6; the probe's 1.4
    const double ring = 3.0 + gap;
    for (int k = 0; k < 12; ++k)
      spheres.push_back({{ring * std::cos(k * kPi / 6), ring * std::sin(k * kPi / 6), 0}, 1.6});
    ExactTracker tracker(makeScene(spheres), 1.4);
    const Contact c = walkTo(tracker, {0, 0, 6}, {0, 0, -6}, 0.02);
    if (gap < 0) {
      CHECK(c.feature == Feature::Point);  // many spheres meet here: a vertex of the ring's own symmetry
      CHECK(c.scp.A.z > 0);
    } else {
      CHECK(c.feature == Feature::Free);
    }
    CHECK(deepest_A(spheres, 1.4, c.scp.A) <= 1e-12);
  }
}

TEST_CASE(
    "spheres that touch in one point or overlap by 1e-9 A: the SCP passes from one to the other without a fault") {
  for (const double overlap : {0.0, 1e-9}) {
    CAPTURE(overlap);
    const std::vector<Sphere> spheres{{{-3.0 + overlap / 2, 0, 0}, 1.6}, {{3.0 - overlap / 2, 0, 0}, 1.6}};
    ExactTracker tracker(makeScene(spheres), 1.4);
    walkTo(tracker, {-3, 0, 5}, {-3, 0, 2.4}, 0.05);
    Contact c;
    for (double x = -3; x <= 3; x += 0.01) {
      c = tracker.step({{x, 0.001, 2.4 * std::abs(x) / 3.0}});
      REQUIRE(deepest_A(spheres, 1.4, c.scp.A) <= 1e-12);
    }
    CHECK(c.atoms[0] == 1);
  }
}

TEST_CASE("in a cubic lattice, where eight spheres meet in each hollow's point, the hollow holds and lets go") {
  std::vector<Sphere> spheres;
  for (int x = 0; x < 4; ++x)
    for (int y = 0; y < 4; ++y) spheres.push_back({{2.0 * x, 2.0 * y, 0}, 0.2});
  ExactTracker tracker(makeScene(spheres), 1.4);
  // Four spheres of 1.6 A at the corners of a square of 2 A meet sqrt(1.6^2 - 2) A above its middle.
  const Contact c = walkTo(tracker, {3, 3, 4}, {3, 3, 0.2}, 0.02);
  CHECK(c.feature == Feature::Point);
  checkNear(c.scp.A, {3, 3, std::sqrt(0.56)}, 1e-12);
  walkTo(tracker, {3, 3, 0.2}, {5, 3.3, 0.4}, 0.02);
  const Contact next = tracker.step({{5, 3, 0.3}});
  checkNear(next.scp.A, {5, 3, std::sqrt(0.56)}, 1e-12);
}

TEST_CASE("spheres inside others and duplicates have no effect") {
  const std::vector<Sphere> plain{{{0, 0, 0}, 1.6}, {{2, 0, 0}, 1.6}};
  std::vector<Sphere> doubled = plain;
  doubled.push_back(plain[0]);
  doubled.push_back({{0.1, 0, 0}, 1.2});
  doubled.push_back({{2, 0, 0}, 1.0});
  ExactTracker a(makeScene(plain), 1.4), b(makeScene(doubled), 1.4);
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal;
  Vec3 h{0, 0, 4};
  for (int k = 0; k < 20'000; ++k) {
    const Contact one = a.step({h}), two = b.step({h});
    REQUIRE(one.feature == two.feature);
    REQUIRE(one.atoms == two.atoms);
    REQUIRE(glm::distance(one.scp.A, two.scp.A) <= 1e-12);
    h += 0.05 * Vec3(normal(random), normal(random), normal(random)) - 0.002 * (h - Vec3(1, 0, 1.5));
  }
}

TEST_CASE("a million angstroms from the origin the SCP is the same to the rounding of such coordinates, 5e-10 A") {
  const Vec3 off(1e6, -1e6, 1e6);
  std::vector<Sphere> near{{{0, 0, 0}, 1.6}, {{2, 0, 0}, 1.5}, {{1, 1.75, 0}, 1.7}};
  std::vector<Sphere> far = near;
  for (Sphere& b : far) b.centre_A += off;
  ExactTracker a(makeScene(near), 1.4), b(makeScene(far), 1.4);
  a.step({{1, 0.5, 6}});
  b.step({Vec3(1, 0.5, 6) + off});
  for (int k = 0; k < 5000; ++k) {
    const Vec3 h(1 + 0.7 * std::sin(0.003 * k), 0.5 + 0.7 * std::cos(0.007 * k), 2.0);
    const Contact one = a.step({h}), two = b.step({h + off});
    REQUIRE(one.touching() == two.touching());
    REQUIRE(glm::distance(one.scp.A + off, two.scp.A) <= 5e-10);
  }
}

TEST_CASE("when the probe swells from 1.4 to 2.4 A while touching, the SCP is carried out by 1 A and back again") {
  const std::vector<Sphere> spheres{{{0, 0, 0}, 1.6}};
  ExactTracker tracker(makeScene(spheres), 1.4);
  walkTo(tracker, {0, 0, 5}, {0, 0, 2}, 0.1);
  tracker.setProbe(2.4);
  checkNear(tracker.step({{0, 0, 2}}).scp.A, {0, 0, 4}, 1e-12);
  tracker.setProbe(1.4);
  checkNear(tracker.step({{0, 0, 2}}).scp.A, {0, 0, 3}, 1e-12);
  tracker.setProbe(std::nan(""));
  CHECK(tracker.probe_A() == 1.4);
}

TEST_CASE("changing the probe every tick while sliding over 50 random spheres never puts the SCP deeper than 1e-9 A") {
  const unsigned seed = 3;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> place(-5, 5), radius(1.4, 1.9);
  std::normal_distribution<double> normal;
  std::vector<Sphere> spheres(50);
  for (Sphere& b : spheres) b = {{place(random), place(random), place(random)}, radius(random)};
  ExactTracker tracker(makeScene(spheres), 1.4);
  tracker.step({{0, 0, 15}});
  Vec3 h{0, 0, 8};
  double probe = 1.4;
  int touching = 0;
  for (int k = 0; k < 20'000; ++k) {
    probe = 1.5 + std::sin(0.01 * k);
    tracker.setProbe(probe);
    const Contact c = tracker.step({h});
    touching += c.touching();
    if (c.fault == Fault::None) REQUIRE(deepest_A(spheres, probe, c.scp.A) <= 1e-9);
    h += 0.03 * Vec3(normal(random), normal(random), normal(random)) - 0.004 * h * (glm::length(h) > 6.0 ? 1.0 : -1.0);
  }
  CHECK(touching > 5000);
}

TEST_CASE("a pocket that the growing surface closes over the SCP gives StartedInside and no contact") {
  // The middle of a cube of eight spheres: a pocket for a small probe that a larger one fills.
  std::vector<Sphere> spheres;
  for (int k = 0; k < 8; ++k) spheres.push_back({{k & 1 ? 2.0 : -2.0, k & 2 ? 2.0 : -2.0, k & 4 ? 2.0 : -2.0}, 1.6});
  ExactTracker tracker(makeScene(spheres), 0.5);
  CHECK(tracker.step({{0, 0, 0}}).fault == Fault::None);
  tracker.setProbe(2.2);
  const Contact c = tracker.step({{0, 0, 0}});
  CHECK(c.fault == Fault::StartedInside);
  CHECK_FALSE(c.touching());
}

TEST_CASE("nothing is modelled in free space, and after touching one sphere of 2000 one is") {
  std::vector<Sphere> spheres;
  for (int k = 0; k < 2000; ++k) spheres.push_back({{4.0 * (k % 20), 4.0 * (k / 20 % 10), 4.0 * (k / 200)}, 1.6});
  ExactTracker tracker(makeScene(spheres), 1.0);
  walkTo(tracker, {-20, -20, -20}, {-10, -10, -10}, 0.1);
  CHECK(tracker.memoryUsage().atoms_modelled == 0);
  walkTo(tracker, {0, 0, -6}, {0, 0, -2.0}, 0.1);
  CHECK(tracker.memoryUsage().atoms_modelled == 1);
}
