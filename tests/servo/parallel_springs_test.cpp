// Parallel springs: the penalty method is as stiff as the sum of all spheres that push, and the loop's bound must hold
// for the sum. The device is a model in a hand, in a closed loop through the servo step.
#include <doctest/doctest.h>

#include <cmath>

#include "engine/bench/scenes.h"
#include "engine/device/device_model.h"
#include "engine/device/simulated_device.h"
#include "engine/haptics/methods.h"
#include "engine/haptics/wrapped_interaction.h"
#include "engine/servo/servo_step.h"
#include "tests/haptics/walk.h"

using namespace moltact;

namespace {

// So many spheres of 1.7 A whose centres lie within 0.2 A: inflated, all of them push at once, nearly along one direction.
std::vector<Sphere> heap(int n) {
  scenes::Random random(7);
  std::vector<Sphere> out;
  for (int k = 0; k < n; ++k) out.push_back({random.direction() * random.uniform(0.0, 0.2), 1.7});
  return out;
}

std::unique_ptr<Tracker> penalty(const std::vector<Sphere>& spheres) {
  return findMethod("penalty")->make(test::makeScene(spheres), kWaterProbe_A);
}

// As if a single spring pulled.
class ReportedAsOne final : public WrappedInteraction {
 public:
  using WrappedInteraction::WrappedInteraction;
  Response respond(const PoseA& pose) noexcept override {
    Response out = inner().respond(pose);
    out.stiffness_factor = 1.0;
    return out;
  }
};

struct Pressed {
  double greatest_m_per_s = 0.0;  // of the device, from half a second after the hand has stopped on
  double spring_N_per_mm = 0.0;   // the force over the pull that the interaction answered, at the end
  double parallel = 0.0;
  int braked = 0, cut = 0;  // ticks
};

// An open device: little friction, small steps, two ticks of delay.
DeviceParameters slippery() {
  DeviceParameters device;
  device.friction_N = 0.03;
  device.damping_N_s_per_m = 0.05;
  device.resolution_mm = 0.02;
  device.delay_ticks = 2;
  return device;
}

// A hand moves along z to 8 mm below the heap's surface within 0.8 s and rests there for 1.2 s.
Pressed press(Interaction& felt, const DeviceParameters& device, const HandParameters& hand,
              double asked_N_per_mm = 0.5) {
  ServoSettings settings;
  settings.stiffness_N_per_mm = asked_N_per_mm;
  settings.workspace.A_per_mm = 0.25;
  const double surface_mm = (1.7 + kWaterProbe_A) / settings.workspace.A_per_mm;
  const auto target = [&](int k) { return PointMm{{0.3, 0.2, surface_mm + 2.0 - 10.0 * std::min(1.0, k / 800.0)}}; };
  DeviceModel model(device, hand, target(0));
  ServoStep step(describe(device));
  Pressed out;
  for (int k = 0; k < 2000; ++k) {
    const ServoSample sample = step.tick(settings, &felt, {.position = model.sensed()});
    model.tick(sample.force, target(k));
    out.braked += sample.limits.has(Limit::Damping);
    out.cut += sample.limits.has(Limit::EnergyCut);
    if (k >= 1300) out.greatest_m_per_s = std::max(out.greatest_m_per_s, glm::length(model.velocity_m_per_s()));
    const double stretch_mm = glm::length(sample.contact.displacement_A) / settings.workspace.A_per_mm;
    if (stretch_mm > 0.0 && !sample.limits.has(Limit::Clamp) && !sample.limits.has(Limit::Damping))
      out.spring_N_per_mm = glm::length(sample.force.N) / stretch_mm;
    out.parallel = sample.stiffness_factor;
  }
  return out;
}

}  // namespace

TEST_CASE(
    "twelve spheres round one centre, pressed 8 mm deep with a slippery device in a hand of 100 or 300 N/m: with all "
    "twelve "
    "springs within the bound the device rests below 2 mm/s; taken for one they drive it at more than 0.1 m/s until "
    "the "
    "energy limit cuts") {
  for (const HandParameters& hand : {HandParameters{100, 2}, HandParameters{300, 5}}) {
    CAPTURE(hand.stiffness_N_per_m);
    const DeviceParameters device = slippery();
    const std::unique_ptr<Interaction> counted = penalty(heap(12));
    const Pressed rests = press(*counted, device, hand);
    CHECK(rests.parallel == doctest::Approx(12.0).epsilon(0.01));
    CHECK(rests.greatest_m_per_s < 0.002);
    CHECK(rests.cut == 0);
    const double bound = steadyStiffness_N_per_mm(0.5, describe(device));
    CHECK(rests.spring_N_per_mm == doctest::Approx(bound / rests.parallel).epsilon(0.01));
    ReportedAsOne as_one(penalty(heap(12)));
    const Pressed shakes = press(as_one, device, hand);
    CHECK(shakes.greatest_m_per_s > 0.1);
    CHECK(shakes.cut > 0);
  }
}

TEST_CASE(
    "a single sphere is pressed with the stiffness that is asked, however they are counted, and so are two that bear "
    "it") {
  const std::unique_ptr<Interaction> one = penalty(heap(1));
  const Pressed alone = press(*one, {}, {300, 5});
  CHECK(alone.parallel == doctest::Approx(1.0));
  CHECK(alone.spring_N_per_mm == doctest::Approx(0.5).epsilon(0.01));
  // Twice 0.3 N/mm are within the 0.73 N/mm of the device.
  const std::unique_ptr<Interaction> two = penalty(heap(2));
  const Pressed both = press(*two, {}, {300, 5}, 0.3);
  CHECK(both.parallel == doctest::Approx(2.0).epsilon(0.01));
  CHECK(both.spring_N_per_mm == doctest::Approx(0.3).epsilon(0.01));  // of each: the pull is the sum of both
}
