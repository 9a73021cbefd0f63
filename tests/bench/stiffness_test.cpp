// The maximum stable stiffness, against the closed-form bound and against a plain wall.
#include "engine/bench/stiffness.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/servo/plain_trackers.h"

using namespace moltact;
using namespace moltact::bench;

namespace {

const glm::dmat3 kStraight(1.0);

double onWall(const StiffnessSetup& setup) {
  return stiffestStable([] { return std::make_unique<WallTracker>(0.0); }, Vec3(0), Vec3(0, 0, 1), kStraight, setup);
}

double at(const std::string& place, const char* method, const StiffnessSetup& setup) {
  for (const StiffnessPlace& p : stiffnessPlaces())
    if (p.name == place)
      return stiffestStable(
          [&] {
            return findMethod(method)->make(std::make_shared<const SphereGrid>(p.scene.spheres), p.scene.probe_A);
          },
          p.surface, p.out, kStraight, setup);
  FAIL("no place " << place);
  return 0;
}

}  // namespace

TEST_CASE("each place lies on the surface, and 0.8 A out of it is free") {
  for (const StiffnessPlace& p : stiffnessPlaces()) {
    CAPTURE(p.name);
    const auto exact = findMethod("exact")->make(std::make_shared<const SphereGrid>(p.scene.spheres), p.scene.probe_A);
    CHECK_FALSE(exact->step({p.surface + 0.8 * p.out}).touching());
    CHECK_FALSE(exact->step({p.surface + 1e-6 * p.out}).touching());
    const Contact in = exact->step({p.surface - 0.3 * p.out});
    CHECK(in.touching());
    CHECK(glm::distance(in.scp.A, p.surface) < 1e-6);
  }
}

TEST_CASE(
    "without friction a wall stays stable below the bound b / (T/2 + t_d) of a sampled spring with delay, "
    "and not at it: with a hand 1.47 N/mm, without 0.133") {
  for (const StiffnessSetup& setup : stiffnessSetups()) {
    if (setup.device.friction_N > 0) continue;
    CAPTURE(setup.name);
    const double bound = (setup.device.damping_N_s_per_m + setup.hand.damping_N_s_per_m) /
                         (setup.device.tick_s * (0.5 + setup.device.delay_ticks)) * 1e-3;
    CHECK(onWall(setup) < bound);
    CHECK(onWall(setup) > 0.6 * bound);
  }
}

TEST_CASE(
    "pressed straight along an axis exact holds what a plain wall holds, to 3 %, on a sphere, in a crease, "
    "in pits and a hole; penalty no more than 60 % of it in a crease") {
  const StiffnessSetup setup = stiffnessSetups().front();
  const double wall = onWall(setup);
  CHECK(wall > 1);
  CHECK(wall < 10);
  for (const StiffnessPlace& p : stiffnessPlaces()) {
    CAPTURE(p.name);
    CHECK(at(p.name, "exact", setup) == doctest::Approx(wall).epsilon(0.03));
  }
  CHECK(at("crease", "penalty", setup) < 0.6 * wall);
  CHECK(at("hole too narrow", "penalty", setup) == 0);  // it pushes the device through
}

TEST_CASE(
    "what a wall holds depends on the direction of the press only because the sensor's steps lie along its "
    "axes: without them it is the same along all, to 3 %") {
  StiffnessSetup setup = stiffnessSetups().front();
  const auto slanted = [&](double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    const glm::dmat3 turn = glm::dmat3(1, 0, 0, 0, c, s, 0, -s, c) * glm::dmat3(c, s, 0, -s, c, 0, 0, 0, 1);
    return stiffestStable([] { return std::make_unique<WallTracker>(0.0); }, Vec3(0), Vec3(0, 0, 1), turn, setup);
  };
  double low = 100, high = 0;
  for (const double angle : {0.0, 0.4, 0.8, 1.1})
    low = std::min(low, slanted(angle)), high = std::max(high, slanted(angle));
  CHECK(high > 1.2 * low);
  setup.device.resolution_mm = 0;
  const double straight = slanted(0);
  for (const double angle : {0.4, 0.8, 1.1}) CHECK(slanted(angle) == doctest::Approx(straight).epsilon(0.03));
}
