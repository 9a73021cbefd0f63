// The servo loop's logic on a virtual clock: every tick is a call, time passes by ticks.
#include "engine/servo/servo_step.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "engine/bench/scenes.h"
#include "engine/haptics/methods.h"
#include "tests/haptics/walk.h"

using namespace moltact;

namespace {

std::unique_ptr<Tracker> oneBall() {  // 1.6 A at the origin
  return methods().front().make(test::makeScene({{{0, 0, 0}, 1.6}}), kWaterProbe_A);
}

DevicePose at(double x_mm, double y_mm, double z_mm) { return {.position = {{x_mm, y_mm, z_mm}}}; }

// Runs the loop for `ticks` ticks with the hand held still.
ServoSample hold(ServoStep& step, const ServoSettings& settings, Tracker* tracker, DevicePose pose, int ticks) {
  ServoSample last;
  for (int k = 0; k < ticks; ++k) last = step.tick(settings, tracker, pose);
  return last;
}

}  // namespace

TEST_CASE("pressing 1 mm into a wall of 0.5 N/mm gives 0.5 N outward once the soft start is over") {
  auto tracker = oneBall();
  ServoStep step;
  ServoSettings settings;  // 0.25 A a mm: the surface at 3 A lies at 12 mm
  hold(step, settings, tracker.get(), at(0, 0, 20), 10);
  const ServoSample s = hold(step, settings, tracker.get(), at(0, 0, 11), 500);
  CHECK(s.contact.feature == Feature::Sphere);
  CHECK(s.force.N.z == doctest::Approx(0.5).epsilon(1e-12));
  CHECK(std::abs(s.force.N.x) + std::abs(s.force.N.y) < 1e-12);
}

TEST_CASE("with the device turned by 90 degrees the force is turned with it") {
  auto tracker = oneBall();
  ServoStep step;
  ServoSettings settings;
  settings.workspace.turn = glm::dmat3(Vec3(0, 1, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1));  // device x is the molecule's y
  hold(step, settings, tracker.get(), at(20, 0, 0), 300);
  const ServoSample s = hold(step, settings, tracker.get(), at(11, 0, 0), 500);
  CHECK(s.hip.A.y == doctest::Approx(2.75));
  CHECK(s.force.N.x == doctest::Approx(0.5).epsilon(1e-12));
}

TEST_CASE("a force of 10 mm x 0.5 N/mm is clamped to 3.3 N and keeps its direction") {
  auto tracker = oneBall();
  ServoStep step;
  ServoSettings settings;
  hold(step, settings, tracker.get(), at(0, 12, 16), 300);
  const ServoSample s = hold(step, settings, tracker.get(), at(0, 1.2, 1.6), 500);
  CHECK(glm::length(s.force.N) == doctest::Approx(3.3).epsilon(1e-12));
  CHECK(s.force.N.y / s.force.N.z == doctest::Approx(0.75).epsilon(1e-9));
}

TEST_CASE("after a start the force grows by at most 3.3 N x 1 ms / 250 ms a tick") {
  auto tracker = oneBall();
  ServoStep step;
  const ServoSettings settings;
  step.tick(settings, tracker.get(), at(0, 0, 20));
  double last = glm::length(step.tick(settings, tracker.get(), at(0, 0, 2)).force.N);
  CHECK(last <= 2 * 3.3 / 250.0 + 1e-12);  // the second tick since the start
  for (int k = 0; k < 400; ++k) {
    const double now = glm::length(step.tick(settings, tracker.get(), at(0, 0, 2)).force.N);
    CHECK(now - last <= 3.3 * 1.0 / 250.0 + 1e-12);
    last = now;
  }
  CHECK(last == doctest::Approx(3.3));
}

TEST_CASE("a new tracker under the hand gives no force: the HIP starts inside until it has been outside") {
  auto first = oneBall(), second = oneBall();
  ServoStep step;
  const ServoSettings settings;
  hold(step, settings, first.get(), at(0, 0, 20), 10);
  CHECK(glm::length(hold(step, settings, first.get(), at(0, 0, 10), 400).force.N) > 0.9);
  const ServoSample swapped = hold(step, settings, second.get(), at(0, 0, 10), 400);
  CHECK(swapped.contact.fault == Fault::StartedInside);
  CHECK(swapped.force.N == Vec3(0));
  hold(step, settings, second.get(), at(0, 0, 20), 10);
  CHECK(glm::length(hold(step, settings, second.get(), at(0, 0, 10), 400).force.N) == doctest::Approx(1.0));
}

TEST_CASE("without a tracker, with the force off, and for a NaN from the device the force is zero") {
  auto tracker = oneBall();
  ServoStep step;
  ServoSettings settings;
  CHECK(hold(step, settings, nullptr, at(0, 0, 10), 5).force.N == Vec3(0));
  hold(step, settings, tracker.get(), at(0, 0, 20), 300);
  hold(step, settings, tracker.get(), at(0, 0, 10), 300);
  const double nan = std::nan("");
  const ServoSample bad = step.tick(settings, tracker.get(), at(nan, 0, 0));
  CHECK(bad.contact.fault == Fault::NotFinite);
  CHECK(bad.force.N == Vec3(0));
  const ServoSample after = step.tick(settings, tracker.get(), at(0, 0, 10));
  CHECK(glm::length(after.force.N) < 0.01);  // it comes back softly
  settings.force_on = false;
  const ServoSample off = step.tick(settings, tracker.get(), at(0, 0, 10));
  CHECK(off.contact.touching());
  CHECK(off.force.N == Vec3(0));
}

TEST_CASE("settings that are not finite or out of range give no force beyond the clamp and no NaN") {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, inf, -inf, -1.0, 1e300}) {
    CAPTURE(bad);
    auto tracker = oneBall();
    ServoStep step;
    ServoSettings settings;
    hold(step, settings, tracker.get(), at(0, 0, 20), 300);
    settings.stiffness_N_per_mm = bad;
    settings.probe_A = bad;
    const ServoSample s = hold(step, settings, tracker.get(), at(0, 0, 10), 300);
    CHECK(std::isfinite(s.force.N.x + s.force.N.y + s.force.N.z));
    CHECK(glm::length(s.force.N) <= 3.3 + 1e-12);
  }
}

TEST_CASE("a new probe radius is reached at 8 A/s: from 1.4 to 2.2 A in 100 ticks, under the hand, without a leap") {
  auto tracker = oneBall();
  ServoStep step;
  ServoSettings settings;
  settings.max_force_N = 10;
  hold(step, settings, tracker.get(), at(0, 0, 20), 300);
  double last = hold(step, settings, tracker.get(), at(0, 0, 11), 300).force.N.z;
  settings.probe_A = 2.2;
  for (int k = 0; k < 100; ++k) {
    const ServoSample s = step.tick(settings, tracker.get(), at(0, 0, 11));
    CHECK(s.force.N.z - last == doctest::Approx(0.008 / 0.25 * 0.5).epsilon(1e-6));  // 8 um of surface at 0.25 A a mm
    last = s.force.N.z;
  }
  CHECK(tracker->probe_A() == doctest::Approx(2.2));
}

TEST_CASE("the same hand gives the same forces to the last bit, over 20 000 ticks on 50 random balls") {
  const scenes::Scene scene = scenes::cluster(50, 9);
  const scenes::Path path = scenes::walk(scene, 20'000, 10);
  const auto run = [&] {
    auto tracker = methods().front().make(test::makeScene(scene.balls), scene.probe_A);
    ServoStep step;
    const ServoSettings settings;
    std::vector<Vec3> forces;
    for (const Vec3& hip : path) forces.push_back(step.tick(settings, tracker.get(), {.position = settings.workspace.toDevice({hip})}).force.N);
    return forces;
  };
  CHECK(run() == run());
}
