// No tunnelling of the exact rigid body: an oracle over all pairs looks at every place of every step between two ticks, and
// walls and cages are judged by side, from the poses alone.
#include <doctest/doctest.h>

#include <cmath>

#include "engine/haptics/body/exact_body.h"
#include "tests/haptics/body_paths.h"
#include "tests/haptics/body_way.h"
#include "tests/haptics/walk.h"

using namespace moltact;
using test::BodyWay;

namespace {

const Vec3 kPathX(1, 0, 0), kPathZ(0, 0, 1);

std::vector<Sphere> onSphere(int n, double radius_A, double each_A) {
  std::vector<Sphere> out;
  for (int k = 0; k < n; ++k) {
    const double z = 1.0 - (2.0 * k + 1.0) / n, r = std::sqrt(1.0 - z * z), a = k * kTwoPi * 0.618033988749895;
    out.push_back({radius_A * Vec3(r * std::cos(a), r * std::sin(a), z), each_A});
  }
  return out;
}

// The largest distance of a place on a sphere about the origin from the nearest centre, to 0.05 A above.
double covering_A(const std::vector<Sphere>& spheres, double radius_A) {
  double most = 0.0;
  for (const Sphere& at : onSphere(100'000, radius_A, 0.0)) {
    double nearest = 1e9;
    for (const Sphere& s : spheres) nearest = std::min(nearest, glm::distance(s.centre_A, at.centre_A));
    most = std::max(most, nearest);
  }
  return most + 0.1;  // the places are less than 0.1 A apart
}

std::vector<Sphere> wall(int n, double apart_A, double radius_A) {
  std::vector<Sphere> out;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) out.push_back({apart_A * Vec3(i - 0.5 * (n - 1), j - 0.5 * (n - 1), 0), radius_A});
  return out;
}

// Follows a path with an observed body; every `lose(k)` is a tick that does not come.
struct Followed {
  long ticks = 0, pressed = 0;
};
template <class Lost>
Followed follow(ExactBody& felt, BodyWay& way, const std::vector<PoseA>& path, Lost lost) {
  Followed out;
  for (std::size_t k = 0; k < path.size(); ++k) {
    if (lost(k)) continue;
    const Response r = felt.respond(path[k]);
    way.judge(r);
    ++out.ticks, out.pressed += r.contact.touching();
  }
  return out;
}

void check(const BodyWay& way) {
  CHECK(way.broken == 0);
  CHECK(way.unknown == 0);
  CHECK(way.least_gap_A > -1e-9);
}

}  // namespace

TEST_CASE(
    "the oracle finds an overlap at no place of any step between ticks: pressed, passing at 2 A a tick, jumping, and "
    "with "
    "up to 40 ticks lost in a row, bodies of 2 to 20 spheres") {
  long places = 0, steps = 0, pressed = 0;
  for (const int n : {2, 6, 20}) {
    const auto spheres = scenes::cluster(100, std::uint64_t(n)).spheres;
    const auto body = test::chainBody(n, std::uint64_t(n));
    for (int how = 0; how < 4; ++how) {
      CAPTURE(n);
      CAPTURE(how);
      const auto path = test::bodyPath(spheres, body->reach_A, how == 0 ? 500 : 200, std::uint64_t(n),
                                       how == 1 ? 2.0 : 0.05, how == 1 ? 0.1 : 0.008, 3.0, how == 2 ? 13 : 0);
      ExactBody felt(test::makeScene(spheres), body);
      BodyWay way(spheres, body);
      felt.observe(&way);
      scenes::Random random(100 + std::uint64_t(n));
      int lost = 0;
      const Followed all = follow(felt, way, path, [&](std::size_t k) {
        if (how != 3 || k == 0) return false;
        if (lost == 0) lost = 1 + int(random.uniform(0.0, 40.0));
        return --lost > 0;
      });
      check(way);
      places += way.places, steps += way.count, pressed += all.pressed;
    }
  }
  CHECK(pressed > 500);
  CHECK(steps > 5'000);
  CHECK(places > 50'000);
}

TEST_CASE("the judge of paths finds a step through a thin wall, one that begins elsewhere, and one back to nowhere") {
  const auto spheres = wall(9, 3.0, 1.7);
  const auto body = bodyOfSpheres({{{1.2, 0, 0}, 1.2}, {{-1.2, 0, 0}, 1.2}});
  BodyWay way(spheres, body);
  const auto at = [](double z) { return PoseA{{{0, 0, z}}, kNoRotation}; };
  Response end;
  way.placed(at(6));
  end.body_pose = at(-6);
  way.moved(at(6), at(-6), 0.0);
  way.judge(end);
  CHECK(way.unknown == 1);
  CHECK(way.least_gap_A < -1.0);
  CHECK(way.broken == 0);
  end.body_pose = at(-8);
  way.moved(at(-7), at(-8), 0.0);
  way.judge(end);
  CHECK(way.broken == 1);
  way.returned(at(-7.5));
  end.body_pose = at(-7.5);
  way.judge(end);
  CHECK(way.broken == 2);
  end.body_pose = at(-9);  // a pose without a step
  way.judge(end);
  CHECK(way.broken == 3);
}

TEST_CASE(
    "a body in a closed cage stays inside while the hand jumps 500 A out and back 60 times, turned at will; back at "
    "the "
    "middle it is free") {
  constexpr double kCage_A = 12.0, kSphere_A = 1.7;
  const auto cage = onSphere(200, kCage_A, kSphere_A);
  for (const int n : {1, 2, 6}) {
    CAPTURE(n);
    const auto body = test::chainBody(n, std::uint64_t(n));
    double least_A = 1e9;
    for (const Sphere& s : body->spheres) least_A = std::min(least_A, s.radius_A);
    REQUIRE(covering_A(cage, kCage_A) < kSphere_A + least_A);  // no centre can pass: the cage is closed
    ExactBody felt(test::makeScene(cage), body);
    BodyWay way(cage, body);
    felt.observe(&way);
    scenes::Random random{std::uint64_t(n)};
    long outside = 0, pressed = 0;
    const auto tick = [&](const PoseA& hand) {
      const Response r = felt.respond(hand);
      way.judge(r);
      REQUIRE(r.body_pose);
      for (const Sphere& s : body->spheres)
        outside += !(glm::length(r.body_pose->place.A + r.body_pose->orientation * s.centre_A) < kCage_A);
      pressed += r.contact.touching();
      return r;
    };
    tick({});
    for (int k = 0; k < 60; ++k) {
      const Vec3 out = 500.0 * random.direction();
      const Quat turn = glm::angleAxis(random.uniform(-1.5, 1.5), random.direction());
      for (int j = 0; j < 4; ++j) tick({{out}, turn});
      for (int j = 0; j < (k % 2 ? 1 : 0); ++j) tick({{-out}, turn});
      if (k % 5 == 4) tick({});
    }
    Response last;
    for (int k = 0; k < 30; ++k) last = tick({});
    CHECK(outside == 0);
    CHECK(pressed > 100);
    CHECK_FALSE(last.acts());
    CHECK(glm::length(last.body_pose->place.A) < 1e-9);
    check(way);
  }
}

TEST_CASE(
    "a thin wall holds a body on its side at 0.02 to 1000 A a tick, from both sides, straight and turned; the hand "
    "back, "
    "it is free again") {
  const auto spheres = wall(21, 3.0, 1.7);
  const auto grid = test::makeScene(spheres);
  for (const double speed : {0.02, 0.1, 0.5, 2.0, 12.0, 50.0, 200.0, 1000.0})
    for (const double side : {1.0, -1.0})
      for (const double turned : {0.0, 0.4}) {
        CAPTURE(speed);
        CAPTURE(side);
        CAPTURE(turned);
        const auto body = bodyOfSpheres({{{1.2, 0, 0}, 1.2}, {{-1.2, 0, 0}, 1.2}, {{0, 1.1, 0.8}, 1.0}});
        ExactBody felt(grid, body);
        BodyWay way(spheres, body);
        felt.observe(&way);
        long across = 0;
        const auto tick = [&](double z, double turn) {
          const Response r =
              felt.respond({{{0.4, -0.3, side * z}}, glm::angleAxis(turn, glm::normalize(kPathX + 0.5 * kPathZ))});
          way.judge(r);
          REQUIRE(r.body_pose);
          for (const Sphere& s : body->spheres)
            across += !(side * (r.body_pose->place.A + r.body_pose->orientation * s.centre_A).z > 0.0);
          return r;
        };
        const double far = std::max(8.0, 0.5 * speed);
        const int n = int(std::ceil(2.0 * far / speed));
        for (int k = 0; k <= n; ++k) tick(far - 2.0 * far * k / n, turned * k / n);
        Response r;
        for (int k = 0; k < 5; ++k) r = tick(-far, turned);
        CHECK(r.contact.touching());
        CHECK(r.contact.displacement_A.z * side > far);
        for (int k = n; k >= 0; --k) tick(far - 2.0 * far * k / n, turned * k / n);
        for (int k = 0; k < 20; ++k) r = tick(far, 0.0);
        CHECK(across == 0);
        CHECK_FALSE(r.acts());
        CHECK(glm::distance(r.body_pose->place.A, Vec3(0.4, -0.3, side * far)) < 1e-9);
        check(way);
      }
}

TEST_CASE("a row of spheres passes a ring with 1.01e-10 A to spare without sinking by more than 2e-7 A at any place") {
  const auto ring = scenes::ring(6, 1.01e-10).spheres;
  const auto row = bodyOfSpheres({{{0, 0, -2.4}, 1.4}, {{0, 0, 0}, 1.4}, {{0, 0, 2.4}, 1.4}});
  ExactBody felt(test::makeScene(ring), row);
  BodyWay way(ring, row);
  felt.observe(&way);
  Response r;
  for (int k = 0; k <= 400; ++k) {
    r = felt.respond({{{0, 0, 8.0 - 0.04 * k}}, glm::angleAxis(0.1 * std::sin(0.05 * k), kPathX)});
    way.judge(r);
  }
  CHECK(r.body_pose->place.A.z < -7.0);
  CHECK(way.broken == 0);
  CHECK(way.unknown == 0);
  CHECK(way.least_gap_A > -2e-7);
}

TEST_CASE(
    "a scene that breathes by 0.3 A sinks into the body by less than a piece of its motion, 0.02 A, before the body is "
    "moved out") {
  const auto spheres = scenes::cluster(100, 4).spheres;
  const auto body = test::chainBody(8, 4);
  std::vector<Sphere> swollen = spheres;
  scenes::Random random(9);
  for (Sphere& s : swollen) s.radius_A += random.uniform(-0.1, 0.2), s.centre_A += 0.2 * random.direction();
  ExactBody felt(test::makeScene(spheres), body);
  BodyWay way(spheres, body);
  felt.observe(&way);
  const auto path = test::bodyPath(spheres, body->reach_A, 500, 6, 0.04, 0.004, 2.0);
  std::vector<std::unique_ptr<const SphereMotion>> motions;
  long pressed = 0;
  for (std::size_t k = 0; k < path.size(); ++k) {
    if (k % 10 == 0) {
      auto made = motions.empty() ? SphereMotion::make(spheres, swollen, 10)
                                  : SphereMotion::after(*motions.back(), (k / 10) % 2 ? spheres : swollen, 10);
      REQUIRE(made);
      felt.setMotion(made->get());
      motions.push_back(std::move(*made));
    }
    felt.advanceTo(double(k % 10 + 1) / 10.0);
    const Response r = felt.respond(path[k]);
    way.judge(r, motions.back().get());
    pressed += r.contact.touching();
  }
  CHECK(pressed > 100);
  CHECK(way.broken == 0);
  CHECK(way.count > 300);
  CHECK(way.least_gap_A > -0.021);
}
