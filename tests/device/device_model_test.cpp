// The simulated device against closed forms: decay, deflection, oscillation, and the bounds of a sampled stiffness.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "engine/bench/closed_loop.h"
#include "engine/servo/plain_trackers.h"

using namespace moltact;
using namespace moltact::bench;

namespace {

// Neither friction nor rounding nor a limit: what the textbook formulas speak of.
DeviceParameters ideal(double damping, int delay = 0) {
  DeviceParameters d;
  d.damping_N_s_per_m = damping;
  d.friction_N = 0;
  d.resolution_mm = 0;
  d.max_force_N = 1e9;
  d.delay_ticks = delay;
  return d;
}

// The device is struck against a two-sided spring of the given stiffness, sampled; how its swing has grown
// after 2 s.
double growth(double damping, int delay, double stiffness_N_per_m) {
  DeviceModel device(ideal(damping, delay), kNoHand, {});
  device.strike({1e-4, 0, 0});
  double first = 0, last = 0;
  for (int k = 0; k < 2000; ++k) {
    const double x = 1e-3 * device.sensed().mm.x;
    device.tick({{-stiffness_N_per_m * x, 0, 0}}, {});
    const double swing = std::abs(device.position().mm.x);
    if (k < 200) first = std::max(first, swing);
    if (k >= 1800) last = std::max(last, swing);
  }
  return last / first;
}

// The same for a handle that is struck about an oblique axis against a torsion spring.
double turningGrowth(double damping_N_mm_s, int delay, double stiffness_N_mm) {
  DeviceParameters parameters = ideal(0.2, delay);
  parameters.rotational_damping_N_mm_s = damping_N_mm_s;
  parameters.max_torque_N_mm = 1e9;
  const Vec3 axis = glm::normalize(Vec3(1, 2, -1));
  DeviceModel device(parameters, kNoHand, {});
  device.strike(Vec3(0.0), 1e-3 * axis);
  double first = 0, last = 0;
  for (int k = 0; k < 2000; ++k) {
    const Vec3 angle = rotationBetween(kNoRotation, device.orientation());
    device.tick({{}, -stiffness_N_mm * angle}, {}, kNoRotation);
    const double swing = glm::length(rotationBetween(kNoRotation, device.orientation()));
    if (k < 200) first = std::max(first, swing);
    if (k >= 1800) last = std::max(last, swing);
  }
  return last / first;
}

}  // namespace

TEST_CASE(
    "a handle of 5e-5 kg m2 that turns at 2 rad/s against 1 N mm s/rad comes to rest after I w / b_r = 0.1 rad, and 50 "
    "N "
    "mm against a wrist of 500 N mm/rad turn it by 0.1 rad") {
  DeviceModel free(ideal(0.2), kNoHand, {});
  const Vec3 axis = glm::normalize(Vec3(0.2, -1, 0.5));
  free.strike(Vec3(0.0), 0.1 * axis);
  CHECK(glm::distance(free.turning_rad_per_s(), 2.0 * axis) < 1e-12);
  for (int k = 0; k < 50; ++k) free.tick({}, {});
  CHECK(glm::length(free.turning_rad_per_s()) == doctest::Approx(2.0 * std::exp(-1.0)).epsilon(1e-9));
  for (int k = 0; k < 2000; ++k) free.tick({}, {});
  CHECK(glm::distance(rotationBetween(kNoRotation, free.orientation()), 0.1 * axis) < 1e-9);

  DeviceModel held({.delay_ticks = 0}, {}, {});
  for (int k = 0; k < 3000; ++k) held.tick({{}, 50.0 * axis}, {}, kNoRotation);
  CHECK(glm::distance(rotationBetween(kNoRotation, held.orientation()), 0.1 * axis) < 1e-9);
  CHECK(glm::length(held.turning_rad_per_s()) < 1e-9);
  // Beyond the peak torque of 170 N mm.
  for (int k = 0; k < 3000; ++k) held.tick({{}, 400.0 * axis}, {}, kNoRotation);
  CHECK(glm::distance(rotationBetween(kNoRotation, held.orientation()), 0.34 * axis) < 1e-9);
  // The wrist turns the handle along.
  const Quat wrist = glm::angleAxis(2.5, axis);
  for (int k = 0; k < 3000; ++k)
    held.tick({{}, Vec3(std::numeric_limits<double>::quiet_NaN())}, {},
              glm::slerp(kNoRotation, wrist, std::min(1.0, k / 1000.0)));
  CHECK(glm::length(rotationBetween(wrist, held.orientation())) < 1e-9);
}

TEST_CASE(
    "a sampled torsion spring is stable below b_r / (T/2 + t_d) and unstable above, with no delay and with one tick of "
    "it") {
  for (const int delay : {0, 1})
    for (const double b : {0.5, 1.0, 2.0}) {
      const double bound = b / (0.0005 + 0.001 * delay);
      CAPTURE(delay);
      CAPTURE(b);
      CHECK(turningGrowth(b, delay, 0.85 * bound) < 0.9);
      CHECK(turningGrowth(b, delay, 1.15 * bound) > 1.1);
    }
}

TEST_CASE("in free flight 45 g at 0.1 m/s against 0.2 N s/m come to rest after m v / b = 22.5 mm") {
  DeviceModel device(ideal(0.2), kNoHand, {});
  device.strike({0.0045, 0, 0});
  for (int k = 0; k < 100; ++k) device.tick({}, {});
  const double tau = 0.045 / 0.2;
  CHECK(device.velocity_m_per_s().x == doctest::Approx(0.1 * std::exp(-0.1 / tau)).epsilon(1e-9));
  CHECK(device.position().mm.x == doctest::Approx(1e3 * 0.1 * tau * (1 - std::exp(-0.1 / tau))).epsilon(1e-9));
  for (int k = 0; k < 5000; ++k) device.tick({}, {});
  CHECK(device.position().mm.x == doctest::Approx(22.5).epsilon(1e-6));
}

TEST_CASE("1.2 N against a hand of 300 N/m give 4 mm") {
  DeviceModel device(ideal(0.2), {300, 5}, {});
  for (int k = 0; k < 3000; ++k) device.tick({{0, 1.2, 0}}, {});
  CHECK(device.position().mm.y == doctest::Approx(4.0).epsilon(1e-9));
  CHECK(glm::length(device.velocity_m_per_s()) < 1e-9);
}

TEST_CASE(
    "an undamped hand's spring of 300 N/m swings for 10 s without gaining or losing a millionth of its "
    "energy") {
  DeviceModel device(ideal(0), {300, 0}, {{5, 0, 0}});
  const auto energy = [&] {
    const double x = 1e-3 * device.position().mm.x, v = device.velocity_m_per_s().x;
    return 0.5 * 300 * x * x + 0.5 * 0.045 * v * v;
  };
  // The hand moves to the origin in the first tick and stays.
  device.tick({}, {});
  device.tick({}, {});
  const double at_first = energy();
  for (int k = 0; k < 10'000; ++k) device.tick({}, {});
  CHECK(energy() == doctest::Approx(at_first).epsilon(1e-6));
}

TEST_CASE("positions are quantized to 0.055 mm, and a command of 5 N becomes 3.3 N one tick later") {
  DeviceModel device({}, kNoHand, {{0.1, -0.1, 0.02}});
  CHECK(device.sensed().mm.x == doctest::Approx(0.11));
  CHECK(device.sensed().mm.y == doctest::Approx(-0.11));
  CHECK(device.sensed().mm.z == 0);
  device.tick({{3, 0, 4}}, {});
  CHECK(device.held().N == Vec3(0));
  device.tick({{std::numeric_limits<double>::quiet_NaN(), 0, 0}}, {});
  CHECK(device.held().N.x == doctest::Approx(3.3 * 0.6));
  CHECK(device.held().N.z == doctest::Approx(3.3 * 0.8));
  device.tick({}, {});
  CHECK(device.held().N == Vec3(0));
}

TEST_CASE("Coulomb friction of 0.26 N brings 45 g at 0.2 m/s to a stop after about m v^2 / 2 f = 3.46 mm") {
  DeviceParameters d = ideal(0);
  d.friction_N = 0.26;
  d.friction_speed_m_per_s = 0.001;
  d.substeps = 100;
  DeviceModel device(d, kNoHand, {});
  device.strike({0.009, 0, 0});
  for (int k = 0; k < 1000; ++k) device.tick({}, {});
  CHECK(device.position().mm.x == doctest::Approx(3.46).epsilon(0.01));
}

TEST_CASE(
    "a sampled spring is stable below b / (T/2 + t_d) and unstable above, with no delay and with one tick of "
    "it") {
  for (const int delay : {0, 1})
    for (const double b : {0.2, 0.5, 1.0}) {
      const double bound = b / (0.0005 + 0.001 * delay);
      CAPTURE(delay);
      CAPTURE(b);
      CHECK(growth(b, delay, 0.85 * bound) < 0.9);
      CHECK(growth(b, delay, 1.15 * bound) > 1.1);
    }
}

TEST_CASE(
    "the passivity observer sees no energy in a spring that gives back what it got, and 0.2 J in a push "
    "without cause between 2 releases") {
  PassivityObserver spring;
  spring.release();
  double x = 0;
  for (int k = 0; k < 1000; ++k) {
    const double next = 0.005 * std::sin(0.01 * (k + 1)), f = -300 * 0.5 * (x + next);
    spring.add({f, 0, 0}, {next - x, 0, 0}, std::abs(next) < 1e-5);
    x = next;
  }
  CHECK(spring.made_J() < 1e-7);  // what the spring holds at 0.01 mm, where it is called released
  PassivityObserver push;
  push.release();
  push.add({-1, 0, 0}, {0.1, 0, 0}, true);  // takes 0.1 J
  CHECK(push.made_J() == 0);
  push.add({2, 0, 0}, {0.1, 0, 0}, true);
  CHECK(push.made_J() == doctest::Approx(0.2));
}
