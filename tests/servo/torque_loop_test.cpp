// Torque in a closed loop on a virtual clock: the exact body in a cage, the servo step, and a simulated device with three
// torques in a hand. Without a bound a struck handle comes to rest below b_r / (T/2 + t_d) and vibrates above. A sampled
// spring K leaves the effective damping b_r - K (T/2 + t_d), from which the rate of the decay follows. The safety stage
// keeps K at half of the bound.
#include <doctest/doctest.h>

#include <cmath>

#include "engine/bench/closed_loop.h"
#include "engine/bench/scenes.h"
#include "engine/device/device_model.h"
#include "engine/device/simulated_device.h"
#include "engine/haptics/body/exact_body.h"
#include "engine/servo/servo_step.h"
#include "tests/haptics/walk.h"

using namespace moltact;

namespace {

constexpr double kAsked_N_per_mm = 0.2, kA_per_mm = 0.3;

// A cross that a cage keeps from turning by more than 0.01 rad and from moving by more than 0.02 A.
std::vector<Sphere> cross() { return {{{3, 0, 0}, 0.8}, {{-3, 0, 0}, 0.8}, {{0, 3, 0}, 0.8}, {{0, -3, 0}, 0.8}}; }
std::vector<Sphere> cage() {
  constexpr double kRoom_A = 0.02;
  std::vector<Sphere> out;
  for (const Sphere& end : cross()) {
    const Vec3 side = glm::cross(Vec3(0, 0, 1), end.centre_A) / 3.0;
    for (const double sign : {1.0, -1.0}) {
      out.push_back({end.centre_A + sign * (30.0 + end.radius_A + kRoom_A) * Vec3(0, 0, 1), 30.0});
      out.push_back({end.centre_A + sign * (0.5 + end.radius_A + kRoom_A) * side, 0.5});
    }
  }
  return out;
}

// A wrist so light that only the device damps.
HandParameters lightHand(scenes::Random& random) {
  return {random.uniform(100, 300), random.uniform(3, 6), random.uniform(50, 300), random.uniform(0.0, 0.05)};
}

DeviceParameters torqueDevice(double b_r) {
  DeviceParameters out;
  out.resolution_mm = 0.0;
  out.rotational_damping_N_mm_s = b_r;
  return out;
}

double bound_N_mm(const DeviceParameters& device) {
  return device.rotational_damping_N_mm_s / (0.5 * kTick_s + device.delay_ticks * kTick_s);
}

struct Turned {
  double fastest_rad_per_s = 0.0;  // in the last half second
  double before_rad_per_s = 0.0;   // in the half second before
  double torque_N_mm = 0.0;        // mean of the same time
  double stiffness_N_mm = 0.0;     // K_r, at the end
  int contact = 0, torques = 0;    // ticks
};

// The wrist turns by 0.12 rad about a random axis within 0.3 s and rests for 2 s; the handle is struck after 0.5 s.
// `rotational_N_mm`: the rotational stiffness at the asked stiffness.
Turned turn(std::uint64_t seed, const DeviceParameters& device, double rotational_N_mm, bool guarded) {
  scenes::Random random(seed);
  const HandParameters hand = lightHand(random);
  const Vec3 axis = random.direction();
  ServoSettings settings;
  settings.stiffness_N_per_mm = kAsked_N_per_mm;
  settings.workspace.A_per_mm = kA_per_mm;
  settings.max_force_N = device.max_force_N;
  const double lever_mm2 = rotational_N_mm / kAsked_N_per_mm;
  ExactBody felt(test::makeScene(cage()), bodyOfSpheres(cross()), lever_mm2 * kA_per_mm * kA_per_mm);
  DeviceModel model(device, hand, {});
  std::unique_ptr<ServoStep> step = std::make_unique<ServoStep>(describe(device));
  if (!guarded) step = std::make_unique<bench::UnguardedStep>(describe(device));
  Turned out;
  constexpr int kTicks = 2300, kLast = 500;
  for (int k = 0; k < kTicks; ++k) {
    const ServoSample s = step->tick(settings, &felt, {.position = model.sensed(), .orientation = model.orientation()});
    if (k == 500) model.strike(Vec3(0.0), 1e-3 * axis);
    model.tick({s.force, s.torque_N_mm}, {}, glm::angleAxis(0.12 * std::min(1.0, k / 300.0), axis));
    out.contact += s.contact.touching();
    out.torques += s.torque_N_mm != Vec3(0.0);
    out.stiffness_N_mm = s.spring_N_per_A * kA_per_mm * lever_mm2;
    if (k >= kTicks - 2 * kLast && k < kTicks - kLast)
      out.before_rad_per_s = std::max(out.before_rad_per_s, glm::length(model.turning_rad_per_s()));
    if (k < kTicks - kLast) continue;
    out.fastest_rad_per_s = std::max(out.fastest_rad_per_s, glm::length(model.turning_rad_per_s()));
    out.torque_N_mm += glm::length(s.torque_N_mm) / kLast;
  }
  return out;
}

}  // namespace

TEST_CASE(
    "20 seeds, wrists and axes: a struck handle against an exact body's torque comes to rest at 0.85 of b_r / (T/2 + "
    "t_d), as fast as 0.15 b_r damps it, and vibrates at 1.3 of it; with the safety stage it rests at half of the "
    "bound, "
    "however stiff it is asked") {
  constexpr double kBelow = 0.85;
  double loudest_below = 0, quietest_above = 1e9, loudest_guarded = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    const DeviceParameters device = torqueDevice(seed % 2 ? 1.0 : 0.6);
    const double bound = bound_N_mm(device);
    const Turned below = turn(seed, device, kBelow * bound, false), above = turn(seed, device, 1.3 * bound, false),
                 guarded = turn(seed, device, 1.3 * bound, true);
    CHECK(below.contact > 1000);
    CHECK(above.contact > 1000);
    CHECK(guarded.contact > 1000);
    CHECK(guarded.torques > 1000);
    CHECK(below.stiffness_N_mm == doctest::Approx(kBelow * bound));
    CHECK(above.stiffness_N_mm == doctest::Approx(1.3 * bound));
    // The amplitude falls by exp(-b t / 2 I); the wrist damps a little more.
    const double damping_N_m_s = 1e-3 * (1.0 - kBelow) * device.rotational_damping_N_mm_s,
                 falls = std::exp(-damping_N_m_s * 0.5 / (2.0 * device.inertia_kg_m2));
    CHECK(below.fastest_rad_per_s < 1.02 * falls * below.before_rad_per_s);
    // The stage's margin of two, and the bound itself.
    CHECK(guarded.stiffness_N_mm == doctest::Approx(0.5 * bound));
    CHECK(guarded.torque_N_mm > 1.0);
    loudest_below = std::max(loudest_below, below.fastest_rad_per_s);
    quietest_above = std::min(quietest_above, above.fastest_rad_per_s);
    loudest_guarded = std::max(loudest_guarded, guarded.fastest_rad_per_s);
  }
  MESSAGE("seeds 1 to 20: the handle turns by at most " << loudest_below << " rad/s at 0.85 of the bound, at least "
                                                        << quietest_above << " at 1.3 of it, at most "
                                                        << loudest_guarded << " with the stage");
  CHECK(loudest_below < 0.1);
  CHECK(quietest_above > 1.0);
  CHECK(loudest_guarded < 0.01);
}

TEST_CASE("the simulated stylus drives three torques and knows its rotational damping; a press turns its handle") {
  SimulatedDevice stylus;
  CHECK(stylus.info().dof_out == 6);
  CHECK(stylus.info().max_torque_N_mm == DeviceParameters().max_torque_N_mm);
  CHECK(stylus.info().rotational_damping_N_mm_s == DeviceParameters().rotational_damping_N_mm_s);
  const Quat before = stylus.read(kTick_s).orientation;
  for (int k = 0; k < 300; ++k) stylus.writeWrench({{}, Vec3(0, 0, 50)});
  // 50 N mm against a wrist of 500 N mm/rad.
  CHECK(rotationBetween(before, stylus.read(kTick_s).orientation).z == doctest::Approx(0.1).epsilon(0.02));
  stylus.plug(false);
  for (int k = 0; k < 300; ++k) stylus.writeWrench({{}, Vec3(0, 0, 50)});
  CHECK(std::abs(rotationBetween(before, stylus.read(kTick_s).orientation).z) < 0.01);
}
