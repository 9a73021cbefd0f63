// The exact rigid body against an oracle over all pairs: no overlap, balance of forces, second order, energy. Longer
// runs: MOLTACT_BODY_TICKS=100000 build/release/test_haptics -tc='*body*oracle*'.
#include <doctest/doctest.h>

#include <random>

#include "engine/haptics/sphere_motion.h"
#include "tests/haptics/body_judge.h"
#include "tests/haptics/body_paths.h"

using namespace moltact;
using oracle::BodyOracle;
using test::judge;
using test::ticksPerScene;
using test::Verdict;

TEST_CASE(
    "the oracle finds no lower neighbour where three balls lie in three grooves with 1e-10 A to spare, pressed 20 A "
    "deep; it finds one where a dumbbell balances on a sphere with a curvature of -0.1") {
  std::mt19937_64 random(5);
  constexpr double kSkin_A = 1e-10, kBall_A = 1e4, kArm_A = 3.0 * kBall_A;  // steps of 1e-3 A see planes
  std::vector<Sphere> grooves, balls;
  for (int k = 0; k < 3; ++k) {
    const double angle = kTwoPi * k / 3.0;
    const Vec3 along(std::cos(angle), std::sin(angle), 0), across(-along.y, along.x, 0);
    balls.push_back({kArm_A * along, kBall_A});
    for (const double side : {-kBall_A, kBall_A})
      grooves.push_back({kArm_A * along + side * across - Vec3(0, 0, std::sqrt(3.0) * kBall_A), kBall_A - kSkin_A});
  }
  const BodyOracle coupling(grooves, balls, kArm_A);
  const BodyOracle::Pose rest = BodyOracle::pose({}), below = BodyOracle::pose({{{0, 0, -20}}});
  CHECK(double(coupling.residual(rest, below)) < 1e-12);
  CHECK(!coupling.hasLowerNeighbour(rest, below, 2000, random));
  CHECK(coupling.hasLowerNeighbour(BodyOracle::pose({{{0, 0, 0.01}}}), below, 16, random));

  const double height = std::sqrt(16.0 - 1.0);
  const BodyOracle balance({{Vec3(0), 3.0}}, {{{1, 0, 0}, 1.0}, {{-1, 0, 0}, 1.0}}, 1.0);
  const BodyOracle::Pose on_top = BodyOracle::pose({{{0, 0, height}}});
  for (const double depth : {0.5, 0.9, 1.1, 1.5}) {
    CAPTURE(depth);
    const BodyOracle::Pose hand = BodyOracle::pose({{{0, 0, height * (1.0 - depth)}}});
    CHECK(double(balance.residual(on_top, hand)) < 1e-12);
    CHECK(balance.hasLowerNeighbour(on_top, hand, 1000, random) == (depth > 1.0));
  }
}

TEST_CASE(
    "the oracle finds neither overlap nor imbalance nor a lower neighbour of the exact body's rest, and no tick makes "
    "energy: bodies of 1 to 35 spheres on random clusters") {
  int pressed = 0, unrested = 0, ticks = 0;
  long steps = 0;
  for (const int n : {1, 2, 3, 6, 12, 35}) {
    CAPTURE(n);
    const auto spheres = scenes::cluster(120, std::uint64_t(n)).spheres;
    const auto body = test::chainBody(n, std::uint64_t(n));
    const Verdict v =
        judge(spheres, body,
              test::bodyPath(spheres, body->reach_A, 300 + ticksPerScene(), std::uint64_t(n), 0.04, 0.004, 3.0), 7);
    test::check(v);
    pressed += v.pressed, unrested += v.unrested, ticks += v.ticks, steps += v.steps;
  }
  CHECK(pressed > ticks / 4);
  MESSAGE(unrested << " of " << ticks << " ticks not at rest, " << double(steps) / ticks << " steps a tick");
  CHECK(unrested * 200 <= ticks);
  CHECK(steps <= 4 * ticks);
}

TEST_CASE("the oracle finds the same with jumps of the hand and passes at 2 A and 0.1 rad a tick") {
  int pressed = 0;
  for (const int n : {2, 8, 20}) {
    CAPTURE(n);
    const auto spheres = scenes::cluster(150, std::uint64_t(10 + n)).spheres;
    const auto body = test::chainBody(n, std::uint64_t(n));
    for (const int jump_every : {0, 29}) {
      const Verdict v = judge(spheres, body,
                              test::bodyPath(spheres, body->reach_A, ticksPerScene(), std::uint64_t(n),
                                             jump_every ? 0.04 : 2.0, jump_every ? 0.01 : 0.1, 4.0, jump_every),
                              7);
      test::check(v);
      pressed += v.pressed;
    }
  }
  CHECK(pressed > 300);
}

TEST_CASE("the oracle finds the same in every degenerate scene, with jumps, also a million angstroms from the origin") {
  int pressed = 0;
  for (const scenes::Scene& scene : scenes::all()) {
    CAPTURE(scene.name);
    const auto body = test::chainBody(5, 3);
    const Verdict v = judge(scene.spheres, body,
                            test::bodyPath(scene.spheres, body->reach_A, ticksPerScene(), 5, 0.05, 0.01, 2.5, 53), 7);
    CHECK(double(v.least_gap_A) > 0.0);
    CHECK(double(v.residual) < 1e-6);
    CHECK(double(v.energy_gained_A2) < 1e-9);
    CHECK(v.lower == 0);
    pressed += v.pressed;
  }
  CHECK(pressed > 3000);
}

TEST_CASE(
    "a body in a scene that breathes by 0.3 A overlaps nothing in any tick, and rests in 199 of 200 in balance, with no"
    " lower neighbour") {
  const auto spheres = scenes::cluster(150, 4).spheres;
  const auto body = test::chainBody(10, 4);
  std::vector<Sphere> swollen = spheres;
  scenes::Random random(9);
  for (Sphere& s : swollen) s.radius_A += random.uniform(-0.1, 0.2), s.centre_A += 0.2 * random.direction();
  ExactBody felt(test::makeScene(spheres), body);
  const auto path = test::bodyPath(spheres, body->reach_A, 300 + ticksPerScene(), 6, 0.04, 0.004, 2.0);
  std::unique_ptr<const SphereMotion> motion;
  int ticks = 0, pressed = 0, unrested = 0;
  int judged = 0, lower = 0;
  std::mt19937_64 directions(5);
  long double least = 1.0L, residual = 0.0L;
  for (std::size_t k = 0; k < path.size(); ++k) {
    if (k % 40 == 0) {
      auto made = !motion ? SphereMotion::make(spheres, swollen, 40)
                          : SphereMotion::after(*motion, (k / 40) % 2 ? spheres : swollen, 40);
      REQUIRE(made);
      felt.setMotion(made->get());
      motion = std::move(*made);
    }
    const double fraction = double(k % 40 + 1) / 40.0;
    felt.advanceTo(fraction);
    const Response r = felt.respond(path[k]);
    if (r.contact.fault != Fault::None) continue;
    ++ticks;
    pressed += r.contact.touching();
    unrested += !r.at_rest;
    const BodyOracle oracle(motion->at(fraction), body->spheres, felt.lever_A());
    const BodyOracle::Pose at = BodyOracle::pose(*r.body_pose), to = BodyOracle::pose(felt.coupledHand());
    least = std::min(least, oracle.minGap_A(at));
    if (!r.at_rest) continue;
    residual = std::max(residual, oracle.residual(at, to));
    if (r.contact.touching() && k % 7 == 0) ++judged, lower += oracle.hasLowerNeighbour(at, to, 16, directions);
  }
  CHECK(double(least) > -1e-9);
  CHECK(pressed > ticks / 4);
  CHECK(unrested * 200 <= ticks);
  CHECK(double(residual) < 1e-6);
  CHECK(lower == 0);
  CHECK(judged > 50);
}
