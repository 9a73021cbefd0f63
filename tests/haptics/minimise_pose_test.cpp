// Oracles: closed forms of argon (AMBER: 0.238 kcal/mol at 3.82 A).
#include "engine/haptics/field/minimise_pose.h"

#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "tests/haptics/allocations.h"

using namespace moltact;

namespace {

PairAtom minimisePoseArgon(const Vec3& at) { return {at, 1.91f, 0.238f, 0.0f}; }

PairSum sumOf(const std::vector<PairAtom>& scene, const std::vector<PairAtom>& body) {
  std::vector<Sphere> places;
  for (const PairAtom& a : scene) places.push_back({a.centre_A, 1.0});
  return PairSum(std::make_shared<const SphereGrid>(std::move(places)), scene, body, PairModel{});
}

PoseA turned(const Vec3& at, double angle, const Vec3& axis) {
  return {{at}, glm::angleAxis(angle, glm::normalize(axis))};
}

}  // namespace

TEST_CASE("an argon atom from 3 to 6 A away comes to 3.82 A and -0.238 kcal/mol within 60 steps") {
  PairSum sum = sumOf({minimisePoseArgon({})}, {minimisePoseArgon({})});
  PoseMinimiser minimiser(sum, radiusOfGyration_A(std::vector<PairAtom>{minimisePoseArgon({})}));
  for (const double from : {3.0, 3.5, 4.0, 5.0, 6.0}) {
    CAPTURE(from);
    minimiser.start({{Vec3(0, 0.6 * from, 0.8 * from)}});
    while (minimiser.step()) REQUIRE(minimiser.steps() < 60);
    // Converged at 0.002 kcal/mol/A of a well of 1.17 kcal/mol/A^2.
    CHECK(std::abs(glm::length(minimiser.pose().place.A) - 3.82) < 0.003);
    CHECK(std::abs(minimiser.energy().energy.felt_kcal_mol + 0.238) < 1e-4);
  }
}

TEST_CASE("a pair of argon atoms turns until both are 3.82 A from a third: twice 0.238 kcal/mol") {
  const std::vector<PairAtom> pair{minimisePoseArgon({-1.91, 0, 0}), minimisePoseArgon({1.91, 0, 0})};
  PairSum sum = sumOf({minimisePoseArgon({})}, pair);
  CHECK(radiusOfGyration_A(pair) == doctest::Approx(1.91));
  PoseMinimiser minimiser(sum, radiusOfGyration_A(pair));
  for (const double angle : {0.0, 0.4, 0.8, 1.0}) {
    CAPTURE(angle);
    minimiser.start(turned({0.3, 4.5, 0.2}, angle, {0.2, 0.1, 1}));
    while (minimiser.step()) REQUIRE(minimiser.steps() < 200);
    CHECK(std::abs(minimiser.energy().energy.felt_kcal_mol + 2 * 0.238) < 1e-3);
    for (const PairAtom& atom : pair)
      CHECK(std::abs(glm::length(minimiser.pose().place.A + minimiser.pose().orientation * atom.centre_A) - 3.82) <
            0.01);
  }
}

TEST_CASE(
    "among 400 random atoms the energy never rises from step to step, no step moves the middle by more than 0.2 A, and "
    "within 400 steps the minimum is one of the field: no pose 0.01 A or 0.01 rad beside it is lower by 1e-4 "
    "kcal/mol") {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    CAPTURE(seed);
    std::mt19937 random(seed);
    const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
    const auto any = [&](double size) { return Vec3(in(-size, size), in(-size, size), in(-size, size)); };
    std::vector<PairAtom> scene, body;
    while (scene.size() < 400) {
      const Vec3 at = any(12);
      if (glm::length(at) > 5) scene.push_back({at, float(in(1, 2)), float(in(0.02, 0.2)), float(in(-0.5, 0.5))});
    }
    for (int k = 0; k < 8; ++k) body.push_back({any(2), float(in(1, 2)), float(in(0.02, 0.2)), float(in(-0.5, 0.5))});
    PairSum sum = sumOf(scene, body);
    PoseMinimiser minimiser(sum, radiusOfGyration_A(body));
    minimiser.start(turned(any(0.5), 0.5, any(1)));
    double last = minimiser.energy().energy.felt_kcal_mol;
    const double first = last;
    Vec3 place = minimiser.pose().place.A;
    while (minimiser.step()) {
      REQUIRE(minimiser.steps() < 400);
      REQUIRE(minimiser.energy().energy.felt_kcal_mol <= last);
      REQUIRE(glm::distance(minimiser.pose().place.A, place) <= PoseMinimiser::kMaxStep_A + 1e-9);
      last = minimiser.energy().energy.felt_kcal_mol, place = minimiser.pose().place.A;
    }
    CHECK(minimiser.energy().energy.felt_kcal_mol < first - 0.1);
    PairSum fresh = sumOf(scene, body);
    for (int k = 0; k < 60; ++k) {
      PoseA beside = minimiser.pose();
      if (k % 2)
        beside.place.A += 0.01 * glm::normalize(any(1));
      else
        beside.orientation = glm::angleAxis(0.01, glm::normalize(any(1))) * beside.orientation;
      CHECK(fresh.at(beside).energy.felt_kcal_mol > minimiser.energy().energy.felt_kcal_mol - 1e-4);
    }
  }
}

TEST_CASE("a start far away or not finite is converged at once, and 200 steps allocate nothing") {
  PairSum sum = sumOf({minimisePoseArgon({}), minimisePoseArgon({4, 0, 0})}, {minimisePoseArgon({})});
  PoseMinimiser minimiser(sum, 1.0);
  CHECK_FALSE(minimiser.step());
  for (const Vec3& at : {Vec3(1000, 0, 0), Vec3(NAN, 0, 0), Vec3(INFINITY, 0, 0)}) {
    minimiser.start({{at}});
    CHECK(minimiser.converged());
    CHECK(minimiser.energy().energy.felt_kcal_mol == 0.0);
  }
  const long before = test::allocations();
  for (int k = 0; k < 200; ++k) {
    if (minimiser.converged()) minimiser.start({{Vec3(2.0, 3.0 + 0.01 * k, 1.0)}});
    minimiser.step();
  }
  CHECK(test::allocations() == before);
}
