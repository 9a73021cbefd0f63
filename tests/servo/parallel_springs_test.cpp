// Springs that pull together: what the penalty method answers is as stiff as all the balls that push, and the loop's
// bound has to hold for the sum. The device is a model in a hand, in a closed loop through the servo step.
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

// So many balls of 1.7 A whose centres lie within 0.2 A: inflated, all of them push at once, nearly along one direction.
std::vector<Ball> heap(int n) {
  scenes::Random random(7);
  std::vector<Ball> out;
  for (int k = 0; k < n; ++k) out.push_back({random.direction() * random.uniform(0.0, 0.2), 1.7});
  return out;
}

std::unique_ptr<Tracker> penalty(const std::vector<Ball>& balls) {
  return findMethod("penalty")->make(test::makeScene(balls), kWaterProbe_A);
}

// As if a single spring pulled.
class ToldAsOne final : public WrappedInteraction {
 public:
  using WrappedInteraction::WrappedInteraction;
  double parallelSprings() const noexcept override { return 1.0; }
};

struct Pressed {
  double greatest_m_per_s = 0.0;  // of the device, from half a second after the hand has stopped on
  double spring_N_per_mm = 0.0;   // each spring's, at the end
  double parallel = 0.0;
  int braked = 0, cut = 0;  // ticks
};

// A hand comes in along z to 8 mm under the heap's surface within 0.8 s, asks for 0.5 N/mm, and stands for 1.2 s.
Pressed press(Interaction& felt, const DeviceParameters& device, const HandParameters& hand) {
  ServoSettings settings;
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
    out.parallel = felt.parallelSprings();
  }
  return out;
}

}  // namespace

TEST_CASE("experiment") {
  for (const int n : {1, 2, 4, 12, 40})
    for (const HandParameters& hand :
         {HandParameters{100, 2}, HandParameters{300, 5}, HandParameters{500, 10}, HandParameters{1500, 5}})
      for (const double friction : {0.26, 0.03})
        for (const bool told : {true, false}) {
          DeviceParameters device;
          device.friction_N = friction;
          if (friction < 0.1) device.resolution_mm = 0.02, device.damping_N_s_per_m = 0.05, device.delay_ticks = 2;
          std::unique_ptr<Interaction> felt = penalty(heap(n));
          if (!told) felt = std::make_unique<ToldAsOne>(std::move(felt));
          const Pressed p = press(*felt, device, hand);
          std::printf("%2d balls hand %g friction %g told %d: %.4f m/s spring %.3f parallel %.2f braked %d cut %d\n", n,
                      hand.stiffness_N_per_m, friction, told, p.greatest_m_per_s, p.spring_N_per_mm, p.parallel,
                      p.braked, p.cut);
        }
}
