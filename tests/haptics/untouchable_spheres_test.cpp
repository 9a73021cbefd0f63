// Spheres that are drawn but not felt: with every method, the hand meets the scene as if they did not exist, and the
// others keep their indices.
#include <doctest/doctest.h>

#include <string>

#include "engine/bench/methods/bench_methods.h"
#include "engine/bench/scenes.h"
#include "engine/haptics/methods.h"
#include "engine/haptics/sphere_motion.h"
#include "engine/haptics/sweep.h"
#include "tests/haptics/walk.h"

using namespace moltact;
using bench::benchMethods;

namespace {

const std::vector<Sphere> kPair{{{0, 0, 0}, 1.6}, {{6, 0, 0}, 1.6}};

std::shared_ptr<const SphereGrid> without(std::vector<Sphere> spheres, const std::vector<std::uint32_t>& untouchable) {
  return std::make_shared<const SphereGrid>(std::move(spheres), untouchable);
}

}  // namespace

TEST_CASE(
    "every method's probe passes through the middle of an untouchable sphere, and rests on the other one by its "
    "index") {
  for (const Method& method : benchMethods()) {
    CAPTURE(std::string(method.name));
    const auto tracker = method.make(without(kPair, {0}), 1.4);
    for (int k = 0; k <= 60; ++k) REQUIRE_FALSE(tracker->step({{0.0, 0.0, 6.0 - 0.2 * k}}).touching());
    const Contact other = test::walkTo(*tracker, {6, 0, 6}, {6, 0, 2.5}, 0.05);
    REQUIRE(other.touching());
    CHECK(other.atoms[0] == 1);
    CHECK(glm::distance(other.scp.A, Vec3(6, 0, 3)) < 0.6);
  }
}

TEST_CASE(
    "along 3000 ticks over 50 random spheres of which every third is untouchable, the exact tracker answers to 1e-9 A "
    "as "
    "over the 33 others, with their indices in the whole") {
  const scenes::Scene scene = scenes::cluster(50, 3);
  std::vector<Sphere> others;
  std::vector<std::uint32_t> left_out, index;
  for (std::uint32_t i = 0; i < scene.spheres.size(); ++i)
    if (i % 3 == 0) {
      left_out.push_back(i);
    } else {
      others.push_back(scene.spheres[i]);
      index.push_back(i);
    }
  const auto whole = findMethod("exact")->make(without(scene.spheres, left_out), scene.probe_A);
  const auto part = findMethod("exact")->make(test::makeScene(others), scene.probe_A);
  int touching = 0;
  for (const Vec3& hip : scenes::jumps(scene, 3000, 8)) {
    const Contact a = whole->step({hip}), b = part->step({hip});
    REQUIRE(a.touching() == b.touching());
    if (!a.touching()) continue;
    ++touching;
    REQUIRE(glm::distance(a.scp.A, b.scp.A) < 1e-9);
    for (int k = 0; k < 3; ++k)
      REQUIRE(a.atoms[std::size_t(k)] ==
              (b.atoms[std::size_t(k)] < 0 ? -1 : int(index[std::size_t(b.atoms[std::size_t(k)])])));
  }
  CHECK(touching > 500);
}

TEST_CASE("the box of a scene counts no untouchable sphere, a sweep meets none, and one without any other has no box") {
  const auto one = without(kPair, {1, 7, 1});
  CHECK(one->size() == 2);
  CHECK((one->touchable(0) && !one->touchable(1)));
  CHECK(one->untouchable() == std::vector<std::uint32_t>{1});
  CHECK((one->low_A() == Vec3(-1.6) && one->high_A() == Vec3(1.6)));
  CHECK(sweep(*one, 1.4, {6, 0, 9}, {6, 0, -9}).sphere == -1);
  CHECK(sweep(*one, 1.4, {0, 0, 9}, {0, 0, -9}).sphere == 0);
  const auto none = without(kPair, {0, 1});
  CHECK((none->low_A() == Vec3(0) && none->high_A() == Vec3(0)));
  CHECK(sweep(*none, 1.4, {0, 0, 9}, {0, 0, -9}).sphere == -1);
  CHECK_FALSE(SphereGrid(kPair).hasUntouchable());
}

TEST_CASE("an untouchable sphere that moves through a still probe is not felt on its way, nor in the motion after it") {
  const auto tracker = findMethod("exact")->make(without(kPair, {0}), 1.4);
  const PointA still{{-5, 0, 0}};
  tracker->step(still);
  std::vector<Sphere> to = kPair;
  to[0].centre_A.x = -10;
  const auto first = SphereMotion::make(kPair, to, 33, std::vector<std::uint32_t>{0});
  REQUIRE(first);
  const auto second = SphereMotion::after(**first, kPair, 33);
  REQUIRE(second);
  for (const SphereMotion* motion : {first->get(), second->get()}) {
    REQUIRE(tracker->setMotion(motion));
    for (int k = 1; k <= 33; ++k) {
      tracker->advanceTo(k / 33.0);
      REQUIRE_FALSE(tracker->step(still).touching());
    }
  }
}
