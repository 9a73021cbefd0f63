// The force of a guide: its closed form, that it is the gradient of its energy, and that a closed path costs nothing.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "engine/haptics/guide/guide_layer.h"
#include "tests/haptics/fields.h"

using namespace moltact;

namespace {

constexpr double kPerA = 0.5, kMost_N = 0.8;  // stiffness 0.5 N/A: the greatest force is reached 1.6 A off

Guide guideAlong(std::vector<std::vector<Vec3>> parts, GuideKind kind = GuideKind::Tube, double radius_A = 1.0) {
  return {std::make_shared<const GuidePath>(std::move(parts)), kind, radius_A, kPerA, kMost_N};
}

// A way of `count` random points in a box of 20 A.
std::vector<Vec3> randomWay(std::mt19937& random, int count) {
  std::uniform_real_distribution<double> place(-10.0, 10.0);
  std::vector<Vec3> out;
  for (int k = 0; k < count; ++k) out.push_back({place(random), place(random), place(random)});
  return out;
}

// The distance to the way, from the definition: the least over 4000 points of every piece.
double sampledDistance_A(const std::vector<Vec3>& way, const Vec3& hand) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k + 1 < way.size(); ++k)
    for (int i = 0; i <= 4000; ++i)
      least = std::min(least, glm::distance(hand, way[k] + (way[k + 1] - way[k]) * (i / 4000.0)));
  return least;
}

}  // namespace

TEST_CASE(
    "a straight way 10 A long: a tube of 1 A gives 0 N inside, 0.25 N 1.5 A off and at most 0.8 N; a spring 0.25 N 0.5 "
    "A off") {
  const Guide tube = guideAlong({{{0, 0, 0}, {10, 0, 0}}}),
              spring = guideAlong({{{0, 0, 0}, {10, 0, 0}}}, GuideKind::Spring);
  CHECK(guideForce(tube, {5, 0.99, 0}) == FeltForce{});
  CHECK(guideForce(tube, {5, 0, 0}) == FeltForce{});
  const FeltForce off = guideForce(tube, {5, 1.5, 0});
  CHECK(glm::distance(off.force_N, Vec3(0, -0.25, 0)) < 1e-12);
  CHECK(off.energy_N_A == doctest::Approx(0.5 * 0.5 * 0.5 * 0.5));
  CHECK(off.stiffness_N_per_A == doctest::Approx(0.5));
  const FeltForce far = guideForce(tube, {5, 0, 21});
  CHECK(glm::distance(far.force_N, Vec3(0, 0, -0.8)) < 1e-12);
  // 20 A of stretch: 1.6 A with a rising force, the rest with 0.8 N.
  CHECK(far.energy_N_A == doctest::Approx(0.5 * 0.8 * 1.6 + 0.8 * 18.4));
  CHECK(glm::distance(guideForce(spring, {5, 0, 0.5}).force_N, Vec3(0, 0, -0.25)) < 1e-12);
  CHECK(guideForce(spring, {5, 0, 0}) == FeltForce{});
  // Beyond an end the way is a half sphere: 3 A beyond and 4 A aside are 5 A, 4 A outside of the tube.
  const FeltForce end = guideForce(tube, {13, 4, 0});
  CHECK(glm::distance(end.force_N, 0.8 * Vec3(-0.6, -0.8, 0)) < 1e-12);
}

TEST_CASE("no force acts along a straight way: its part along is below 1e-15 N at 1000 places beside it") {
  const std::uint32_t seed = 20261128;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> aside(-4.0, 4.0), along(0.0, 10.0);
  for (const GuideKind kind : {GuideKind::Spring, GuideKind::Tube}) {
    const Guide guide = guideAlong({{{0, 0, 0}, {2, 0, 0}, {5, 0, 0}, {10, 0, 0}}}, kind);
    for (int k = 0; k < 1000; ++k)
      CHECK(std::abs(guideForce(guide, {along(random), aside(random), aside(random)}).force_N.x) < 1e-15);
  }
}

TEST_CASE(
    "the nearest point of random ways of 2 to 200 points is that of a search over 4000 points of each piece, to 0.01 "
    "A") {
  const std::uint32_t seed = 7;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (const int count : {2, 3, 16, 17, 18, 33, 200}) {
    const std::vector<Vec3> way = randomWay(random, count);
    const GuidePath path({way});
    double length_A = 0.0;
    for (std::size_t k = 0; k + 1 < way.size(); ++k) length_A += glm::distance(way[k], way[k + 1]);
    CHECK(path.length_A() == doctest::Approx(length_A));
    for (const Vec3& hand : randomWay(random, count == 200 ? 4 : 20)) {
      const GuidePath::Nearest near = path.nearest(hand);
      CHECK(near.distance_A == doctest::Approx(glm::distance(hand, near.place_A)));
      CHECK(std::abs(near.distance_A - sampledDistance_A(way, hand)) < 0.01);
      CHECK(glm::distance(path.at(near.along_A), near.place_A) < 1e-9);
    }
  }
}

TEST_CASE("the force is the negative gradient of the energy: central differences at 2000 places agree to 1e-6 N") {
  const std::uint32_t seed = 11;
  CAPTURE(seed);
  std::mt19937 random(seed);
  int compared = 0;
  for (const GuideKind kind : {GuideKind::Spring, GuideKind::Tube}) {
    const Guide guide = guideAlong({randomWay(random, 12)}, kind);
    for (const Vec3& hand : randomWay(random, 1000)) {
      constexpr double h = 1e-5;
      Vec3 slope(0.0);
      bool bends = false;  // where another piece is the nearest one, or the force begins or ends to rise
      const auto pieceAt = [&](const Vec3& p) { return guideForce(guide, p).stiffness_N_per_A; };
      for (int axis = 0; axis < 3; ++axis) {
        Vec3 step(0.0);
        step[axis] = h;
        slope[axis] = (guideForce(guide, hand + step).energy_N_A - guideForce(guide, hand - step).energy_N_A) / (2 * h);
        bends = bends ||
                glm::distance(guideForce(guide, hand + step).force_N, guideForce(guide, hand - step).force_N) >
                    10 * h * kPerA ||
                pieceAt(hand + step) * pieceAt(hand - step) == 0.0;
      }
      if (bends && pieceAt(hand) > 0.0) continue;
      CHECK(glm::distance(guideForce(guide, hand).force_N, -slope) < 1e-6);
      ++compared;
    }
  }
  CHECK(compared > 1900);
}

TEST_CASE(
    "50 random closed paths around random ways cost no work: below 2 parts in 10 000 of the work done and given back") {
  const std::uint32_t seed = 1993;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int round = 0; round < 50; ++round) {
    CAPTURE(round);
    const Guide guide = guideAlong({randomWay(random, 9)}, round % 2 ? GuideKind::Spring : GuideKind::Tube);
    std::vector<Vec3> corners = randomWay(random, 6);
    corners.push_back(corners.front());
    double net = 0.0, sizes = 0.0;
    // Midpoints: the error of a smooth force falls with the square of the step, that of a jump is bounded by it.
    for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
      constexpr int kSteps = 20000;
      const Vec3 step = (corners[k + 1] - corners[k]) / double(kSteps);
      for (int i = 0; i < kSteps; ++i) {
        const double work = glm::dot(guideForce(guide, corners[k] + step * (i + 0.5)).force_N, step);
        net += work;
        sizes += std::abs(work);
      }
    }
    REQUIRE(sizes > 1.0);
    CHECK(std::abs(net) < 2e-4 * sizes);
  }
}

TEST_CASE(
    "a way with a gap has no piece across it: 10 A between two parts do not count for its length and give no force") {
  const GuidePath path({{{0, 0, 0}, {1, 0, 0}}, {{11, 0, 0}, {12, 0, 0}}});
  CHECK(path.length_A() == doctest::Approx(2.0));
  CHECK(path.nearest({5, 0, 0}).distance_A == doctest::Approx(4.0));
  CHECK(path.nearest({7, 0, 0}).along_A == doctest::Approx(1.0));
  CHECK(path.at(1.5) == Vec3(11.5, 0, 0));
  CHECK(path.at(-1.0) == Vec3(0, 0, 0));
  CHECK(path.at(9.0) == Vec3(12, 0, 0));
}

TEST_CASE(
    "bad input: no way, one point, points that are not finite and 10 000 points give no guide or a shorter one, never "
    "a force that is not finite") {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  for (const auto& parts : {std::vector<std::vector<Vec3>>{},
                            {{}},
                            {{{1, 2, 3}}},
                            {{{nan, 0, 0}, {0, inf, 0}}},
                            {{{1, 1, 1}, {1, 1, 1}}}}) {
    CHECK(GuidePath(parts).empty());
    CHECK(guideForce(guideAlong(parts), {1, 0, 0}) == FeltForce{});
  }
  CHECK(guideForce({}, {1, 0, 0}) == FeltForce{});
  const Guide guide = guideAlong({{{0, 0, 0}, {nan, 0, 0}, {2, 0, 0}}});
  CHECK(guide.path->length_A() == doctest::Approx(2.0));
  CHECK(guideForce(guide, {nan, 0, 0}) == FeltForce{});
  CHECK(guideForce(guide, {1, inf, 0}) == FeltForce{});
  CHECK(finite(guideForce(guide, {1e150, 0, 0}).force_N));
  std::vector<Vec3> many;
  for (int k = 0; k < 10000; ++k) many.push_back({double(k), 0, 0});
  CHECK(GuidePath({many}).length_A() == doctest::Approx(double(GuidePath::kMaxPoints - 1)));
}

TEST_CASE(
    "the layer adds a guide of 0.25 N to a field, keeps contact and reactions, and reports a field of 0 N inside the "
    "tube") {
  const Guide guide = guideAlong({{{0, 0, 0}, {10, 0, 0}}});
  GuideLayer alone(std::make_unique<test::OpenSpace>(), guide);
  REQUIRE(alone.respond({{{5, 0.5, 0}}}).field);
  CHECK(alone.respond({{{5, 0.5, 0}}}).field->force_N == Vec3(0.0));
  CHECK(glm::distance(alone.respond({{{5, 1.5, 0}}}).field->force_N, Vec3(0, -0.25, 0)) < 1e-12);
  std::array<AtomForce, 3> room;
  CHECK(alone.reactions(alone.respond({{{5, 1.5, 0}}}), 1.0, 1.0, room) == 0);
  GuideLayer both(std::make_unique<test::InField<test::HarmonicPair>>(
                      std::make_unique<test::OpenSpace>(), test::HarmonicPair{1.0},
                      std::vector<test::InField<test::HarmonicPair>::Atom>{{0, {5, 0, 0}}}),
                  guide);
  const Response sum = both.respond({{{5, 1.5, 0}}});
  CHECK(glm::distance(sum.field->force_N, Vec3(0, -1.75, 0)) < 1e-12);
  CHECK(sum.field->stiffness_N_per_A >= 1.5);
}
