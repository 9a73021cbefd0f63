// The oracle against closed forms: it must be correct before it judges a tracker.
#include "engine/bench/oracle.h"

#include <doctest/doctest.h>

#include <cmath>

#include "engine/bench/scenes.h"

using namespace moltact;
using oracle::atRest;
using oracle::deepest;
using oracle::Oracle;

TEST_CASE("on one sphere of radius 3.1 the SCP lies over the HIP at 3.1 and is gone when the HIP leaves") {
  Oracle o(scenes::oneSphere().spheres, 1.4);
  CHECK_FALSE(o.step({0, 0, 4}).contact);
  const auto in = o.step({0, 0, 2.5});
  CHECK(in.contact);
  CHECK(in.decided);
  CHECK(glm::distance(in.scp_A, {0, 0, 3.1}) < 1e-13);
  const auto aside = o.step({1, 0, 1});
  CHECK(glm::distance(aside.scp_A, Vec3(1, 0, 1) * (3.1 / std::sqrt(2.0))) < 1e-13);
  CHECK_FALSE(o.step({4, 0, 0}).contact);
}

TEST_CASE("a jump from one side of a sphere to the far side outside goes round it and ends without contact") {
  Oracle o({{{0, 0, 0}, 3.0}}, 0);
  o.step({0.5, 0, 4});
  o.step({0.5, 0, 2});
  const auto far = o.step({0.6, 0, -5});
  CHECK(far.decided);
  CHECK_FALSE(far.contact);
}

TEST_CASE("a HIP that stands exactly opposite is undecided, one 0.1 degree aside is decided") {
  Oracle o({{{0, 0, 0}, 3.0}}, 0);
  o.step({0, 0, 4});
  o.step({0, 0, 2});
  CHECK_FALSE(o.step({0, 0, -1}).decided);
  o.place({0, 0, 3});
  const auto aside = o.step({0.002, 0, -1});
  CHECK(aside.decided);
  CHECK(glm::distance(aside.scp_A, glm::normalize(Vec3(0.002, 0, -1)) * 3.0) < 1e-13);
}

TEST_CASE("a HIP on the centre keeps the last SCP") {
  Oracle o({{{0, 0, 0}, 3.0}}, 0);
  o.step({0, 0, 4});
  o.step({0, 0.5, 2});
  const Vec3 before = o.step({0, 0, 1}).scp_A;
  CHECK(glm::distance(o.step({0, 0, 0}).scp_A, before) < 1e-8);  // the perturbed copies may call it undecided
}

TEST_CASE(
    "in the crease of two spheres of radius 5, 6 apart, the SCP lies on the circle of radius 4 nearest the "
    "HIP") {
  Oracle o({{{-3, 0, 0}, 5.0}, {{3, 0, 0}, 5.0}}, 0);
  o.step({0.1, 0, 6});
  const auto in = o.step({0.1, 0, 2});
  CHECK(in.contact);
  CHECK(glm::distance(in.scp_A, {0, 0, 4}) < 1e-13);
  const auto along = o.step({0.1, 1, 1});
  CHECK(glm::distance(along.scp_A, Vec3(0, 1, 1) * (4 / std::sqrt(2.0))) < 1e-13);
  // Beyond the triangle (SCP, centre, centre) the crease is left: the SCP is above the HIP on the right sphere.
  const auto out = o.step({4, 0, 2});
  CHECK(glm::distance(out.scp_A, Vec3(3, 0, 0) + Vec3(1, 0, 2) * (5 / std::sqrt(5.0))) < 1e-13);
}

TEST_CASE(
    "in the pit of three spheres of radius 5 whose centres lie 3 from the axis the SCP is the point 4 up the "
    "axis") {
  std::vector<Sphere> spheres;
  for (const double t : {0.0, 2.0943951023931953, 4.1887902047863905})
    spheres.push_back({{3 * std::cos(t), 3 * std::sin(t), 0}, 5.0});
  Oracle o(spheres, 0);
  o.step({0.01, 0.02, 6});
  const auto in = o.step({0.1, -0.2, 2});
  CHECK(in.contact);
  CHECK(in.decided);
  CHECK(glm::distance(in.scp_A, {0, 0, 4}) < 1e-13);
  CHECK(atRest(spheres, 0, in.scp_A, {0.1, -0.2, 2}, 1e-12));
  CHECK_FALSE(atRest(spheres, 0, in.scp_A, {3, 0, 3}, 1e-3));
  CHECK_FALSE(atRest(spheres, 0, in.scp_A, {0, 0, 5}, 1e-3));
  CHECK(std::abs(deepest(spheres, 0, {0, 0, 4})) < 1e-13);
  CHECK(deepest(spheres, 0, {0, 0, 0}) == doctest::Approx(2));
}

TEST_CASE("a HIP that starts inside has no contact until it has been outside once") {
  Oracle o(scenes::oneSphere().spheres, 1.4);
  CHECK(o.step({0, 0, 1}).started_inside);
  CHECK_FALSE(o.step({0, 0, 2}).contact);
  CHECK_FALSE(o.step({0, 0, 3.2}).started_inside);
  CHECK(o.step({0, 0, 2}).contact);
}

TEST_CASE("between two patches of one sphere the SCP stops at the sphere that parts them") {
  // A thin neighbour across the top of a large sphere: the HIP slides under it from x = -1 to x = 1.
  const std::vector<Sphere> spheres{{{0, 0, 0}, 5.0}, {{0, 0, 5}, 0.5}, {{0, 0.6, 5}, 0.5}, {{0, -0.6, 5}, 0.5}};
  Oracle o(spheres, 0);
  o.step({-2, 0, 6});
  o.step({-1, 0, 4});
  for (double x = -1; x < 0.01; x += 0.02) o.step({x, 0, 4});
  const auto held = o.step({0.1, 0, 4});
  CHECK(held.contact);
  CHECK(held.scp_A.x < -0.4);
  CHECK(atRest(spheres, 0, held.scp_A, {0.1, 0, 4}, 1e-12));
}

TEST_CASE("on every scene the oracle's SCP is in no sphere and at rest, and nearly all of its ticks are decided") {
  const std::uint64_t seed = 11;
  CAPTURE(seed);
  for (const auto& scene : scenes::all(seed)) {
    CAPTURE(scene.name);
    int contacts = 0, undecided = 0, ticks = 0;
    for (const auto& path :
         {scenes::walk(scene, 300, seed), scenes::jumps(scene, 150, seed), scenes::passes(scene, 100, seed)}) {
      Oracle o(scene.spheres, scene.probe_A);
      for (std::size_t k = 0; k < path.size(); ++k) {
        const auto a = o.step(path[k]);
        CAPTURE(k);
        ++ticks;
        contacts += a.contact;
        undecided += !a.decided;
        if (a.started_inside) continue;
        // In double, a million angstroms away, a place is known to 1e-10.
        const double rounding = glm::length(path[k]) > 1e5 ? 1e-9 : 1e-13;
        CHECK(deepest(scene.spheres, scene.probe_A, a.scp_A) < rounding);
        if (a.contact) CHECK(atRest(scene.spheres, scene.probe_A, a.scp_A, path[k], 1e-8));
      }
    }
    CHECK(contacts > ticks / 4);
    CHECK(undecided <= ticks / 20);
  }
}
