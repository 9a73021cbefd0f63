// Energy along closed paths, for interactions whose work is known in closed form.
#include "engine/bench/path_energy.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "engine/bench/passivity_observer.h"
#include "engine/haptics/exact/exact_tracker.h"
#include "engine/haptics/methods.h"

using namespace moltact;
using namespace moltact::bench;

namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kN_per_A = 0.3 / 0.25,
                 kJ_per_N_A = 1e-3 / 0.25;  // the loop's spring; a newton along an angstrom

// exact, with the force turned by an angle about the z-axis: round a sphere's equator it has a part along the
// way.
class TurnedForce final : public Tracker {
 public:
  TurnedForce(std::shared_ptr<const SphereGrid> scene, double probe_A, double angle)
      : exact_(std::move(scene), probe_A), angle_(angle) {}
  Contact step(PointA hip) noexcept override {
    Contact c = exact_.step(hip);
    const Vec3 pull = c.displacement_A;
    const double s = std::sin(angle_), k = std::cos(angle_);
    c.displacement_A = Vec3(k * pull.x - s * pull.y, s * pull.x + k * pull.y, pull.z);
    return c;
  }
  void reset() noexcept override { exact_.reset(); }
  void setProbe(double probe_A) noexcept override { exact_.setProbe(probe_A); }
  double probe_A() const noexcept override { return exact_.probe_A(); }
  MemoryUsage memoryUsage() const noexcept override { return {}; }

 private:
  ExactTracker exact_;
  double angle_;
};

// Straight in from 0.5 A outside to `depth_A` under the equator, then `turns` times round.
scenes::Path rounds(double surface_A, double depth_A, double turns, double step_A) {
  scenes::Path path;
  for (double r = surface_A + 0.5; r > surface_A - depth_A; r -= step_A) path.push_back({r, 0, 0});
  const double r = surface_A - depth_A;
  const int ticks = int(kTurn * std::abs(turns) * r / step_A);
  for (int k = 0; k <= ticks; ++k) {
    const double t = kTurn * turns * k / ticks;
    path.push_back({r * std::cos(t), r * std::sin(t), 0});
  }
  return path;
}

double made(const char* method, const scenes::Scene& scene, const scenes::Path& path) {
  return madeOverClosedPath(
      [&] { return findMethod(method)->make(std::make_shared<const SphereGrid>(scene.spheres), scene.probe_A); }, scene,
      path, {});
}

}  // namespace

TEST_CASE(
    "a force turned by 0.1 rad gives K d sin(0.1) 2 pi r for each of 3 rounds at the depth d, whichever way "
    "it is led") {
  const scenes::Scene scene = scenes::oneSphere();
  const double surface = scene.spheres[0].radius_A + scene.probe_A, d = 0.6;
  const auto turnedBy = [&](double angle, double turns) {
    return madeOverClosedPath(
        [&] {
          return std::make_unique<TurnedForce>(std::make_shared<const SphereGrid>(scene.spheres), scene.probe_A, angle);
        },
        scene, rounds(surface, d, turns, 0.005), {});
  };
  const double expected = kN_per_A * d * std::sin(0.1) * 3 * kTurn * (surface - d) * kJ_per_N_A;
  CHECK(expected > 1e-3);
  CHECK(turnedBy(0.1, 3) == doctest::Approx(expected).epsilon(0.01));
  CHECK(turnedBy(-0.1, 3) == doctest::Approx(expected).epsilon(0.01));
  CHECK(turnedBy(0.1, -3) == doctest::Approx(expected).epsilon(0.01));
  CHECK(turnedBy(0, 3) < 1e-7);
}

TEST_CASE(
    "a force with a potential generates no energy over a closed path: penalty in the overlap of two "
    "spheres, although |F|^2/2k is not its stored energy") {
  const scenes::Scene bond = scenes::bond();
  const double x = bond.spheres[1].centre_A.x / 2;
  scenes::Path path;
  for (double y = 4; y > 1.8; y -= 0.005) path.push_back({x, y, 0});
  for (double t = 0; t < kTurn; t += 0.003)
    path.push_back({x + 0.8 * std::sin(t), 1.8 * std::cos(t), 1.8 * std::sin(t)});
  CHECK(made("penalty", bond, path) < 2e-7);
  CHECK(made("exact", bond, path) < 2e-7);
  // The store that a single spring would have rises by far more along the same path than any work accounts
  // for.
  const auto tracker = findMethod("penalty")->make(std::make_shared<const SphereGrid>(bond.spheres), bond.probe_A);
  double absorbed = 0, worst = 0, lowest = 0;
  Vec3 last = path.front(), force(0);
  for (const Vec3& h : path) {
    const Vec3 before = force;
    force = tracker->step({h}).displacement_A * kN_per_A;
    absorbed -= glm::dot(0.5 * (force + before), h - last) * kJ_per_N_A;
    last = h;
    const double balance = glm::dot(force, force) / (2 * kN_per_A) * kJ_per_N_A - absorbed;
    lowest = std::min(lowest, balance);
    worst = std::max(worst, balance - lowest);
  }
  CHECK(worst > 1e-4);
}

TEST_CASE("an SCP that slips off an edge loses its stored energy and generates none") {
  const scenes::Scene scene = scenes::oneSphere();
  const double surface = scene.spheres[0].radius_A + scene.probe_A;
  scenes::Path path;  // through the sphere beside its centre: the SCP moves around it and loses contact behind
  for (double z = surface + 0.5; z > -surface - 0.5; z -= 0.01) path.push_back({0.3, 0, z});
  CHECK(made("exact", scene, path) < 1e-6);
}

TEST_CASE(
    "the observer counts rises from release to release only: +3 J between two releases is made, -2 J before "
    "them is not regained by it") {
  PassivityObserver observer;
  const Vec3 metre(1, 0, 0);
  observer.add({5, 0, 0}, metre, false);  // before the first release nothing is known
  observer.release();
  observer.add({-2, 0, 0}, metre, false);
  CHECK(observer.made_J() == 0);
  observer.add({0, 0, 0}, metre, true);
  CHECK(observer.made_J() == 0);
  observer.add({9, 0, 0}, metre, false);
  observer.add({-6, 0, 0}, metre, true);
  CHECK(observer.made_J() == doctest::Approx(3));
}

namespace {

// exact, which may keep its stored energy to itself.
class Stated final : public Tracker {
 public:
  Stated(std::shared_ptr<const SphereGrid> scene, bool states) : exact_(std::move(scene), 0.0), states_(states) {}
  Contact step(PointA hip) noexcept override {
    Contact c = exact_.step(hip);
    if (!states_) c.energy_A2 = 0.0;
    return c;
  }
  void reset() noexcept override { exact_.reset(); }
  void setProbe(double probe_A) noexcept override { exact_.setProbe(probe_A); }
  double probe_A() const noexcept override { return exact_.probe_A(); }
  bool setMotion(const SphereMotion* motion) noexcept override { return exact_.setMotion(motion); }
  void advanceTo(double fraction) noexcept override { exact_.advanceTo(fraction); }
  MemoryUsage memoryUsage() const noexcept override { return {}; }

 private:
  ExactTracker exact_;
  bool states_;
};

}  // namespace

TEST_CASE(
    "a wall that comes by d into a resting hand, which then leaves, gives the hand K d^2 / 2: the wall's work where "
    "the "
    "stored energy is stated, generated energy where it is not; a wall that leaves takes energy and gives none") {
  constexpr double kWall_A = 1e6, d = 0.8;
  const scenes::Scene scene{"wall", {{Vec3(0, 0, -kWall_A), kWall_A}}, 0.0};
  const auto grid = std::make_shared<const SphereGrid>(scene.spheres);
  constexpr int kTicks = 100;
  for (const double way : {d, -d}) {
    const auto motion =
        SphereMotion::make(scene.spheres, std::vector<Sphere>{{Vec3(0, 0, way - kWall_A), kWall_A}}, kTicks);
    REQUIRE(motion);
    // In to the depth of a leaving wall, at rest while the wall moves, and out again.
    const double depth = way > 0 ? 0.0 : d;
    scenes::Path path;
    std::vector<MotionPhase> phases;
    for (int k = 0; k <= 200; ++k) path.push_back({0, 0, 0.5 - (0.5 + depth) * k / 200}), phases.push_back({});
    for (int k = 1; k <= kTicks; ++k)
      path.push_back(path.back()), phases.push_back({motion->get(), double(k) / kTicks});
    for (int k = 1; k <= 400; ++k) path.push_back({0, 0, -depth + 2.0 * k / 400});
    const auto made_J = [&](bool states) {
      Stated felt(grid, states);
      return madeOverMoving(felt, scene, phases, path, {});
    };
    CHECK(made_J(true) < 1e-8);
    const double given = way > 0 ? 0.5 * kN_per_A * d * d * kJ_per_N_A : 0.0;
    CHECK(made_J(false) == doctest::Approx(given).epsilon(1e-3));
  }
}
