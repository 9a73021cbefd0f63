// The search of free paths of a body. Oracles: distances of all pairs of spheres, and rings whose openings are known.
#include "engine/lesson/pose_search.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "engine/core/even_directions.h"
#include "engine/core/random.h"

using namespace moltact;

namespace {

// The smallest gap of all pairs.
double oracle_A(const std::vector<Sphere>& scene, const HeldBody& body, const PoseA& pose) {
  double least = 1e300;
  for (const Sphere& s : body.spheres)
    for (const Sphere& o : scene)
      least = std::min(
          least, glm::distance(pose.place.A + pose.orientation * s.centre_A, o.centre_A) - s.radius_A - o.radius_A);
  return least;
}

// `count` spheres of 1.5 A round the z axis, so that a ball of `free_A` just fits between them, in a wall of spheres.
std::vector<Sphere> wall(double free_A) {
  std::vector<Sphere> out;
  constexpr int kCount = 12;
  for (int ring = 0; ring < 9; ++ring)
    for (int k = 0; k < kCount * (ring + 1); ++k) {
      const double angle = 2.0 * std::numbers::pi * k / (kCount * (ring + 1)), r = free_A + 1.5 + 1.4 * ring;
      out.push_back({{r * std::cos(angle), r * std::sin(angle), 0.0}, 1.5});
    }
  return out;
}

std::vector<Sphere> ball(double radius_A, int count) {
  std::vector<Sphere> out;
  for (int k = 0; k < count; ++k) out.push_back({radius_A * evenDirection(k, count), 1.5});
  return out;
}

}  // namespace

TEST_CASE("the gap is the smallest of all pairs to 1e-12 A up to 2 A, a lower bound beyond, negative for an overlap") {
  std::uint64_t random = 7;
  std::vector<Sphere> scene;
  for (int k = 0; k < 200; ++k)
    scene.push_back(
        {Vec3(nextFraction(random), nextFraction(random), nextFraction(random)) * 20.0, 0.5 + nextFraction(random)});
  const auto body = bodyOfSpheres({{{-1.5, 0, 0}, 0.7}, {{0, 0, 0}, 0.4}, {{2, 1, 0}, 0.9}});
  const SphereGrid grid(scene);
  const PoseSpace space(grid, *body);
  int exact = 0, overlaps = 0, far = 0;
  for (int k = 0; k < 4000; ++k) {
    const PoseA pose{{Vec3(nextFraction(random), nextFraction(random), nextFraction(random)) * 34.0 - 7.0},
                     randomOrientation(random)};
    const double gap_A = space.gap_A(pose), truth_A = oracle_A(scene, *body, pose);
    if (truth_A < PoseSpace::kClear_A) {
      CHECK(gap_A < 0.0);
      ++overlaps;
    } else if (truth_A < PoseSpace::kFar_A) {
      CHECK(gap_A == doctest::Approx(truth_A).epsilon(1e-12));
      ++exact;
    } else {
      CHECK(gap_A >= PoseSpace::kFar_A);
      CHECK(gap_A <= truth_A + 1e-6);
      ++far;
    }
  }
  CHECK(exact > 300);
  CHECK(overlaps > 300);
  CHECK(far > 300);
}

TEST_CASE(
    "a stick of five balls, 1.4 A in radius and 10.8 A long, finds its way through a hole of 3.2 A in a wall, turning "
    "into "
    "it; no place of the path, sampled every 0.01 A, overlaps by 0.03 A; through a hole of 1.35 A there is none") {
  std::vector<Sphere> stick;
  for (int k = -2; k <= 2; ++k) stick.push_back({{2.0 * k, 0, 0}, 1.4});
  const auto body = bodyOfSpheres(stick);
  for (const bool wide : {true, false}) {
    const std::vector<Sphere> scene = wall(wide ? 3.2 : 1.35);
    const SphereGrid grid(scene);
    const PoseSpace space(grid, *body);
    // It lies across on one side, and is to come to the other.
    const PoseA start{{{0, 0, 6.0}}, kNoRotation};
    REQUIRE(space.isFree(start));
    PoseSearch search{.allowed = [](const PoseA& p) { return std::hypot(p.place.A.x, p.place.A.y) < 7.0; },
                      .reached = [](const PoseA& p) { return p.place.A.z < -6.0; },
                      .reach_A = 14.0};
    search.max_tests = wide ? 400'000 : 100'000;
    const std::vector<PoseA> path = freePath(space, start, search);
    CHECK(path.empty() == !wide);
    if (!wide) continue;
    REQUIRE(path.size() >= 2);
    CHECK(path.front().place == start.place);
    CHECK(path.back().place.A.z < -6.0);
    double least_A = 1e300;
    for (std::size_t k = 1; k < path.size(); ++k) {
      const int pieces = int(space.motion_A(path[k - 1], path[k]) / 0.01) + 1;
      for (int n = 0; n <= pieces; ++n) {
        const double part = double(n) / pieces;
        least_A = std::min(least_A, oracle_A(scene, *body,
                                             {{path[k - 1].place.A + (path[k].place.A - path[k - 1].place.A) * part},
                                              glm::slerp(path[k - 1].orientation, path[k].orientation, part)}));
      }
    }
    CHECK(least_A > -0.03);
    // The same search gives the same path.
    CHECK(freePath(PoseSpace(grid, *body), start, search).size() == path.size());
  }
}

TEST_CASE("from a closed shell of spheres there is no way out, and the search ends within its budget of tests") {
  const auto body = bodyOfSpheres({{{-0.6, 0, 0}, 0.8}, {{0.6, 0, 0}, 0.8}});
  const SphereGrid shell(ball(5.0, 60));
  const PoseSpace inside(shell, *body);
  PoseSearch search;
  search.max_tests = 20'000;
  CHECK(freePath(inside, {}, search).empty());
  CHECK(inside.tests() < 21'000);
  // With one sphere taken out it comes through the gap and ends outside the box.
  const std::vector<std::uint32_t> open{0, 1, 2, 3};
  const SphereGrid opened(ball(5.0, 60), open);
  const PoseSpace space(opened, *body);
  const std::vector<PoseA> path = freePath(space, {}, {});
  REQUIRE_FALSE(path.empty());
  CHECK(glm::length(path.back().place.A) > 6.5);
  // A body that overlaps has no path at all.
  CHECK(freePath(space, {{{5.0, 0, 0}}}, {}).empty());
}
