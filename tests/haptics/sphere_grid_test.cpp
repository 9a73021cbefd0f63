// The grid against a plain loop over all spheres.
#include "engine/haptics/sphere_grid.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <set>

using namespace moltact;

namespace {

std::set<std::uint32_t> nearByLoop(const SphereGrid& scene, Vec3 p, double margin) {
  std::set<std::uint32_t> out;
  for (std::uint32_t i = 0; i < scene.size(); ++i)
    if (glm::distance(scene[i].centre_A, p) <= scene[i].radius_A + margin) out.insert(i);
  return out;
}

void checkAgainstLoop(const SphereGrid& scene, Vec3 p, double margin) {
  std::vector<std::uint32_t> seen;
  scene.visitNear(p, margin, [&](std::uint32_t i, const Sphere& b) {
    CHECK(b.centre_A == scene[i].centre_A);
    seen.push_back(i);
  });
  const std::set<std::uint32_t> once(seen.begin(), seen.end());
  CHECK_MESSAGE(once.size() == seen.size(), "a ball was visited twice");
  const auto expected = nearByLoop(scene, p, margin);
  CHECK(std::includes(once.begin(), once.end(), expected.begin(), expected.end()));
}

}  // namespace

TEST_CASE("the grid finds every sphere that a loop over 2000 random spheres finds, each once, at 200 places") {
  const unsigned seed = 7;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> coordinate(-30, 30), radius(0.5, 2.0);
  std::vector<Sphere> spheres(2000);
  for (Sphere& b : spheres) b = {{coordinate(random), coordinate(random), coordinate(random)}, radius(random)};
  spheres.push_back({{0, 0, 0}, 25.0});  // one sphere much larger than the rest
  const SphereGrid scene(std::move(spheres));
  for (int k = 0; k < 200; ++k)
    checkAgainstLoop(scene, Vec3(coordinate(random), coordinate(random), coordinate(random)) * 1.3, k % 5);
}

TEST_CASE("a scene of two spheres a million angstroms apart takes less than 4 kB and finds each of them") {
  const SphereGrid scene({{{0, 0, 0}, 1.5}, {{1e6, 1e6, -1e6}, 1.5}});
  CHECK(scene.bytes() < 4096);
  checkAgainstLoop(scene, {0.5, 0, 0}, 1.4);
  checkAgainstLoop(scene, {1e6, 1e6, -1e6}, 1.4);
  checkAgainstLoop(scene, {5e5, 5e5, 5e5}, 1.4);
}

TEST_CASE("of 3 equal spheres among 200 in one cell only the first in the file is visited") {
  for (const int others : {5, 200}) {
    std::vector<Sphere> spheres;
    for (int k = 0; k < others; ++k) spheres.push_back({{0.001 * k, 0.5, 0.5}, 1.5});
    spheres[2] = spheres[3] = spheres[4] = {{0.25, 0.5, 0.5}, 1.7};
    const SphereGrid scene(spheres);
    std::vector<std::uint32_t> seen;
    scene.visitNear({0, 0, 0}, 1.4, [&](std::uint32_t i, const Sphere&) { seen.push_back(i); });
    std::sort(seen.begin(), seen.end());
    CHECK(seen.size() == std::size_t(others - 2));
    CHECK(std::binary_search(seen.begin(), seen.end(), 2u));
    CHECK_FALSE(std::binary_search(seen.begin(), seen.end(), 3u));
    CHECK_FALSE(std::binary_search(seen.begin(), seen.end(), 4u));
  }
}

TEST_CASE("a look over the whole of a small scene visits each of 3 different spheres once, the doubled ones too") {
  const Sphere a{{0, 0, 0}, 1.5}, b{{2, 0, 0}, 1.5}, c{{9, 9, 9}, 1.5};
  const SphereGrid scene({a, a, b, b, b, c, a});
  std::vector<std::uint32_t> seen;
  scene.visitNear({0, 0, 0}, 40.0, [&](std::uint32_t i, const Sphere&) { seen.push_back(i); });
  std::sort(seen.begin(), seen.end());
  CHECK(seen == std::vector<std::uint32_t>{0, 2, 5});
}

TEST_CASE("an empty scene visits nothing") {
  const SphereGrid scene(std::vector<Sphere>{});
  scene.visitNear({0, 0, 0}, 100.0, [](std::uint32_t, const Sphere&) { FAIL("visited a ball of an empty scene"); });
  CHECK(scene.size() == 0);
}

TEST_CASE(
    "2000 spheres inside others are found through the others' grid as a loop finds them, by surface and by centre") {
  const unsigned seed = 11;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> coordinate(-30, 30), radius(0.5, 2.0), part(-0.57, 0.57);
  std::vector<Sphere> bounds, inside;
  for (int i = 0; i < 2000; ++i) {
    const double free = i % 3 ? 1.5 : 0.0;  // how far each can move within its bound
    bounds.push_back({{coordinate(random), coordinate(random), coordinate(random)}, radius(random) + free});
    if (i > 1900) bounds.back().centre_A = {0.001 * i, 5, 5};  // a crowded cell, which has a tree
    inside.push_back({bounds.back().centre_A + free * Vec3(part(random), part(random), part(random)),
                      bounds.back().radius_A - free});
  }
  const std::vector<std::uint32_t> untouchable{3, 1950};
  const SphereGrid outer(bounds, untouchable, SphereGrid::Duplicates::VisitEach);
  const SphereGrid scene = SphereGrid::within(outer, inside), own(inside, untouchable);
  CHECK(scene.low_A() == own.low_A());
  CHECK(scene.high_A() == own.high_A());
  CHECK(scene.untouchable() == untouchable);
  for (int k = 0; k < 200; ++k) {
    const Vec3 p = k % 4 ? 1.3 * Vec3(coordinate(random), coordinate(random), coordinate(random)) : Vec3(1.9, 5, 5.5);
    const double reach = k % 5;
    std::set<std::uint32_t> near, centres, near_seen, centres_seen;
    for (std::uint32_t i = 0; i < inside.size(); ++i) {
      if (!scene.touchable(i)) continue;
      const double distance = glm::distance(inside[i].centre_A, p);
      if (distance <= inside[i].radius_A + reach) near.insert(i);
      if (distance <= reach) centres.insert(i);
    }
    scene.visitNear(p, reach, [&](std::uint32_t i, const Sphere& s) {
      CHECK(s.centre_A == inside[i].centre_A);
      CHECK(near_seen.insert(i).second);
    });
    scene.visitCentresNear(p, reach, [&](std::uint32_t i, const Sphere&) { centres_seen.insert(i); });
    CHECK(std::includes(near_seen.begin(), near_seen.end(), near.begin(), near.end()));
    CHECK(std::includes(centres_seen.begin(), centres_seen.end(), centres.begin(), centres.end()));
    CHECK_FALSE(near_seen.contains(3));
  }
}
