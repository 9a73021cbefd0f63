// The penalty of points against closed forms.
#include "engine/bench/methods/point_penalty.h"

#include <doctest/doctest.h>

#include <cmath>

#include "engine/bench/scenes.h"

using namespace moltact;
using bench::PointPenalty;

namespace {

std::shared_ptr<const SphereGrid> sceneOf(std::vector<Sphere> spheres) {
  return std::make_shared<const SphereGrid>(std::move(spheres));
}

// A lattice of touching spheres in the plane z = 0.
std::vector<Sphere> wall(int half, double apart, double radius) {
  std::vector<Sphere> out;
  for (int i = -half; i <= half; ++i)
    for (int j = -half; j <= half; ++j) out.push_back({{apart * i, apart * j, 0}, radius});
  return out;
}

}  // namespace

TEST_CASE("one point against one sphere: the two springs in series, k kContact / (1 + kContact) times the depth") {
  constexpr double kSum = 3.0 + 1.2, c = PointPenalty::kContact;
  PointPenalty felt(sceneOf({{{0, 0, 0}, 3.0}}), bodyOfSpheres({{{0, 0, 0}, 1.2}}));
  CHECK_FALSE(felt.respond({{{0, 0, 6}}}).acts());
  for (const double depth : {0.01, 0.1, 0.5, 1.0}) {
    const Vec3 hand = (kSum - depth) * glm::normalize(Vec3(1, 2, 3));
    felt.reset();
    felt.respond({{{0, 0, 6}}});
    const Response r = felt.respond({{hand}});
    REQUIRE(r.at_rest);
    REQUIRE(r.contact.touching());
    const double force = depth * c / (1 + c);
    CHECK(glm::distance(r.contact.displacement_A, force * glm::normalize(hand)) < 1e-9);
    CHECK(std::abs(kSum - glm::length(r.body_pose->place.A) - force / c) < 1e-9);  // it overlaps by so much
    CHECK(std::abs(r.contact.energy_A2 - 0.5 * depth * force) < 1e-9);
    CHECK(glm::length(r.torque_A2) < 1e-9);
  }
}

TEST_CASE(
    "a dumbbell pressed by one end onto a sphere: force and torque balance the push of that end, to 1e-9 N and N A") {
  constexpr double kLever = 2.0;
  PointPenalty felt(sceneOf({{{kLever, 0, 0}, 3.0}}), bodyOfSpheres({{{kLever, 0, 0}, 1.2}, {{-kLever, 0, 0}, 1.2}}));
  CHECK(felt.lever_A() == doctest::Approx(kLever));
  felt.respond({{{0, 0, 6}}});
  const Response r = felt.respond({{{0, 0, 3.8}}});
  REQUIRE(r.at_rest);
  const Vec3 arm = r.body_pose->orientation * Vec3(kLever, 0, 0), m = r.body_pose->place.A + arm - Vec3(kLever, 0, 0);
  const Vec3 push = PointPenalty::kContact * (4.2 - glm::length(m)) * glm::normalize(m);
  CHECK(push.z > 0.1);
  CHECK(glm::distance(r.contact.displacement_A, push) < 1e-9);
  CHECK(glm::distance(r.torque_A2, glm::cross(arm, push)) < 1e-9);
}

TEST_CASE("no tick makes energy on a walk over 60 spheres: a hand that stands still finds it falling or at rest") {
  const auto scene = scenes::cluster(60, 3);
  PointPenalty felt(sceneOf(scene.spheres), bodyOfSpheres({{{1, 0, 0}, 1.2}, {{-1, 0, 0}, 1.2}, {{0, 1.5, 0}, 1.0}}));
  int pressed = 0;
  const auto path = scenes::walk(scene, 600, 3);
  for (const Vec3& hand : path) {
    const double before = felt.energyFor_A2({{hand}});
    const Response r = felt.respond({{hand}});
    if (r.contact.fault != Fault::None) continue;
    pressed += r.contact.touching();
    CHECK(felt.energyFor_A2({{hand}}) <= before + 1e-12);
  }
  CHECK(pressed > 300);
}

TEST_CASE("the points pass a wall of touching spheres at 12 A a tick without a force, and are held at 0.02 A a tick") {
  for (const double step : {0.02, 12.0}) {
    CAPTURE(step);
    PointPenalty felt(sceneOf(wall(4, 3.0, 1.7)), bodyOfSpheres({{{1, 0, 0}, 1.2}, {{-1, 0, 0}, 1.2}}));
    Response r;
    for (double z = 6.0; z > -6.0 - 0.5 * step; z -= step) r = felt.respond({{{0.1, 0.2, std::max(z, -6.0)}}});
    CHECK(r.contact.touching() == (step < 1.0));
  }
}
