// Coulomb friction at the SCP: its energy, calls and limits in the servo step.
#include "engine/haptics/friction.h"

#include <doctest/doctest.h>

#include <cmath>
#include <memory>

#include "engine/bench/scenes.h"
#include "engine/device/device_model.h"
#include "engine/device/simulated_device.h"
#include "engine/haptics/methods.h"
#include "engine/servo/plain_trackers.h"
#include "engine/servo/servo_step.h"
#include "tests/haptics/walk.h"

using namespace moltact;

namespace {

constexpr double kCoefficient = 0.4, kStiffness_N_per_mm = 0.3;

struct Slid {
  double worked_J = 0.0;  // by the hand
  int limited = 0;        // ticks in which a limit acted
  ServoSample last;
};

// A wall at z = 0, pressed 4 mm deep; then the hand moves back and forth along x by `half_way_mm`, `times` times at 40
// mm/s.
Slid slide(Interaction& felt, double half_way_mm, int times) {
  DeviceSpecs device = shownForceFigures();
  device.gives_force = true;
  device.delay_s = 0.0;
  ServoStep step(device);
  ServoSettings settings;
  settings.stiffness_N_per_mm = kStiffness_N_per_mm;
  settings.surface.friction.coefficient = kCoefficient;
  Slid out;
  Vec3 at(0, 0, 10), force(0.0);
  bool counts = false;
  const auto go = [&](const Vec3& to) {
    const Vec3 from = at;
    const int ticks = std::max(1, int(std::ceil(glm::distance(from, to) / 0.04)));
    for (int k = 1; k <= ticks; ++k) {
      const Vec3 next = from + (to - from) * (double(k) / ticks);
      out.last = step.tick(settings, &felt, {.position = {next}});
      if (counts) out.worked_J -= 0.5e-3 * glm::dot(force + out.last.force.N, next - at);
      at = next;
      force = out.last.force.N;
      if (counts) out.limited += out.last.limits.any();
    }
  };
  go({0, 0, 5});
  for (int k = 0; k < 600; ++k) go({0, 0, 5});
  go({0, 0, -4});
  go({half_way_mm, 0, -4});
  counts = true;
  for (int k = 0; k < times; ++k) {
    go({-half_way_mm, 0, -4});
    go({half_way_mm, 0, -4});
  }
  return out;
}

std::unique_ptr<Interaction> rough(std::unique_ptr<Interaction> inner, std::shared_ptr<const SphereGrid> scene) {
  return std::make_unique<FrictionLayer>(std::move(inner), std::move(scene), nullptr, nullptr, Friction{kCoefficient});
}

std::unique_ptr<Interaction> roughWall() { return rough(std::make_unique<WallTracker>(0.0), test::makeScene({})); }

}  // namespace

TEST_CASE(
    "friction of 0.4 on a wall pressed 4 mm deep at 0.3 N/mm: 1.2 N of pressing are 0.48 N of drag, and 20 ways to and "
    "fro of 10 mm take the closed form's energy and no limit acts") {
  const auto felt = roughWall();
  const double half_way_mm = 5.0, depth_mm = 4.0;
  const int times = 20;
  const Slid slid = slide(*felt, half_way_mm, times);
  const double pressed_N = kStiffness_N_per_mm * depth_mm, drag_N = kCoefficient * pressed_N;
  CHECK(slid.last.force.N.z == doctest::Approx(pressed_N));
  CHECK(slid.last.force.N.x == doctest::Approx(-drag_N));
  // A loop of force against way: a parallelogram of height 2 drag, 2 half ways less the 2 stretches of the spring wide.
  const double stretch_mm = drag_N / kStiffness_N_per_mm;
  const double loop_J = 1e-3 * 2.0 * drag_N * (2.0 * half_way_mm - 2.0 * stretch_mm);
  CHECK(slid.worked_J == doctest::Approx(times * loop_J).epsilon(0.02));
  CHECK(slid.limited == 0);
}

TEST_CASE(
    "a hand that moves less than the friction holds, 1.5 of 1.6 mm, gets back all that it gives: the SCP sticks") {
  const auto felt = roughWall();
  const Slid slid = slide(*felt, 1.5, 20);
  CHECK(std::abs(slid.worked_J) < 1e-9);
  CHECK(glm::length(slid.last.contact.scp.A) < 1e-9);
  CHECK(slid.limited == 0);
}

TEST_CASE("asked five times for each pose of a walk over 20 atoms, the friction answers as asked once") {
  const scenes::Scene scene = scenes::cluster(20, 5);
  const auto spheres = test::makeScene(scene.spheres);
  const auto exact = [&] { return referenceMethod().make(spheres, scene.probe_A); };
  const auto once = rough(exact(), spheres), often = rough(exact(), spheres);
  int touching = 0;
  double apart = 0.0, dragged = 0.0;
  for (const Vec3& place : scenes::walk(scene, 3000, 5)) {
    const Response one = once->respond({{place}, kNoRotation});
    Response last;
    for (int k = 0; k < 5; ++k) last = often->respond({{place}, kNoRotation});
    touching += one.contact.touching();
    apart = std::max(apart, glm::distance(one.contact.displacement_A, last.contact.displacement_A));
    if (one.contact.feature == Feature::Sphere) {
      const double along =
          glm::length(one.contact.displacement_A -
                      one.contact.normals[0] * glm::dot(one.contact.normals[0], one.contact.displacement_A));
      dragged = std::max(dragged, along / glm::length(one.contact.displacement_A));
    }
  }
  CHECK(touching > 500);
  CHECK(apart < 1e-5);
  // Over a single sphere it drags along it by 0.4 of what it presses with, and never more.
  CHECK(dragged == doctest::Approx(kCoefficient / std::sqrt(1.0 + kCoefficient * kCoefficient)).epsilon(1e-4));
}

TEST_CASE(
    "a slider moved from 0 to 0.4 and back while the hand presses and slides: no soft start, and no tick changes the "
    "force by more than 0.002 of what presses") {
  const auto felt = roughWall();
  DeviceSpecs device = shownForceFigures();
  device.gives_force = true;
  ServoStep step(device);
  ServoSettings settings;
  settings.stiffness_N_per_mm = kStiffness_N_per_mm;
  Vec3 at(0, 0, 10), force(0.0);
  double largest_N = 0.0, least_x_N = 0.0;
  int soft = 0;
  for (int k = 0; k < 4000; ++k) {
    if (k < 300)
      at.z -= 14.0 / 300;
    else
      at.x += 0.005;
    settings.surface.friction.coefficient = k >= 1500 && k < 3000 ? kCoefficient : 0.0;
    const ServoSample now = step.tick(settings, felt.get(), {.position = {at}});
    if (k > 1000) {
      soft += now.limits.has(Limit::SoftStart);
      largest_N = std::max(largest_N, glm::distance(now.force.N, force));
      least_x_N = std::min(least_x_N, now.force.N.x);
    }
    if (k == 2999) CHECK(now.force.N.x == doctest::Approx(-0.48));
    if (k == 3999) CHECK(std::abs(now.force.N.x) < 1e-12);
    force = now.force.N;
  }
  CHECK(soft == 0);
  CHECK(least_x_N == doctest::Approx(-0.48));
  // A stuck contact is dragged by 0.005 mm a tick, a sliding one follows the coefficient by 0.002 of 1.2 N.
  CHECK(largest_N < 0.002 * 1.2 + 0.005 * kStiffness_N_per_mm);
}
