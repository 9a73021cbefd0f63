// The limitations that the header of the measured method states. Oracle: the spheres themselves.
#include "engine/bench/methods/scanned_tracker.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/bench/scenes.h"

using namespace moltact;

namespace {

std::shared_ptr<const SphereGrid> gridOf(std::vector<Sphere> spheres) {
  return std::make_shared<const SphereGrid>(std::move(spheres));
}

}  // namespace

TEST_CASE(
    "over the top of one sphere the SCP on nodes 0.5 A apart is never outside, and at most 0.5^2 / (4 radius) = 0.021 "
    "A "
    "inside, 30 degrees farther down 0.03 A; from below nothing is felt") {
  const auto scene = gridOf({{{0, 0, 0}, 1.6}});
  ScannedTracker tracker(scene, 1.4, 0.5);
  tracker.step({{0, 0, 5}});
  scenes::Random random(4);
  double deepest = 0, on_top = 0, outside = 0;
  for (int k = 0; k < 400; ++k) {
    const double tilt = random.uniform(0, 0.5), round = random.uniform(0, kTwoPi);
    const Vec3 way(std::sin(tilt) * std::cos(round), std::sin(tilt) * std::sin(round), std::cos(tilt));
    const Contact c = tracker.step({2.8 * way});
    REQUIRE(c.touching());
    CHECK(c.atoms[0] == 0);
    deepest = std::max(deepest, 3.0 - glm::length(c.scp.A));
    if (std::hypot(c.scp.A.x, c.scp.A.y) < 0.3) on_top = std::max(on_top, 3.0 - glm::length(c.scp.A));
    outside = std::max(outside, glm::length(c.scp.A) - 3.0);
  }
  CHECK(outside < 1e-9);
  CHECK(deepest < 0.03);
  CHECK(on_top < 0.25 / 12 * 1.02);
  CHECK(on_top > 0.01);
  tracker.reset();
  for (double z = -5; z < -2; z += 0.1) CHECK(tracker.step({{0, 0, z}}).fault == Fault::StartedInside);
}

TEST_CASE("a probe changed in contact scans the same nodes again and carries the SCP to its surface") {
  const auto scene = gridOf({{{0, 0, 0}, 1.6}, {{2.5, 0, 0}, 1.6}});
  ScannedTracker tracker(scene, 1.4, 0.5);
  tracker.step({{0, 0, 5}});
  tracker.step({{0, 0, 2.5}});
  for (const double probe_A : {2.0, 1.0, 3.0, 1.4}) {
    tracker.setProbe(probe_A);
    const Contact c = tracker.step({{0, 0, 2.0}});
    CHECK(std::abs(c.scp.A.z - (1.6 + probe_A)) < 0.05);
  }
  ScannedTracker fresh(scene, 1.4, 0.5);
  fresh.step({{0, 0, 5}});
  CHECK(glm::distance(fresh.step({{0, 0, 2.0}}).scp.A, tracker.step({{0, 0, 2.0}}).scp.A) < 0.02);
}
