// A guide in the servo loop on the virtual clock: the safety stage finds no energy that it makes, a strong one is scaled,
// and a hand that only yields is drawn to the way and not along it.
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "engine/device/device_model.h"
#include "engine/haptics/guide/guide_layer.h"
#include "engine/servo/plain_trackers.h"
#include "engine/servo/servo_step.h"
#include "tests/haptics/fields.h"

using namespace moltact;

namespace {

constexpr double kScale_A_per_mm = 0.25;

DeviceInfo guidedDevice() {
  DeviceInfo info{phantomOmniFigures()};
  info.gives_force = true;
  info.delay_s = 0.0;
  return info;
}

Guide guideInSpace(std::vector<Vec3> way_A, GuideKind kind, double radius_A, double strength = 1.0) {
  return {std::make_shared<const GuidePath>(std::vector<std::vector<Vec3>>{std::move(way_A)}), kind, radius_A,
          strength * kGuideStiffness_N_per_mm / kScale_A_per_mm, strength * kGuideMax_N};
}

// A loop with a guide in empty space; the test says where the hand is.
struct GuidedLoop {
  DeviceInfo info = guidedDevice();
  ServoStep step{info};
  ServoSettings settings;
  GuideLayer felt;
  Vec3 place_mm{0.0}, force_N{0.0};
  double worked_J = 0.0;  // by the device on the hand
  int cut = 0, braked = 0, soft = 0;

  explicit GuidedLoop(Guide guide) : felt(std::make_unique<test::OpenSpace>(), std::move(guide)) {
    settings.workspace.A_per_mm = kScale_A_per_mm;
  }
  ServoSample tick(const Vec3& to_mm) {
    worked_J += 1e-3 * glm::dot(force_N, to_mm - place_mm);
    place_mm = to_mm;
    DevicePose pose;
    pose.position = {to_mm};
    const ServoSample sample = step.tick(settings, &felt, pose);
    force_N = sample.force.N;
    cut += sample.limits.has(Limit::EnergyCut);
    braked += sample.limits.has(Limit::Damping);
    soft += sample.limits.has(Limit::SoftStart);
    return sample;
  }
};

std::vector<Vec3> bentWay(std::mt19937& random) {
  std::uniform_real_distribution<double> place(-8.0, 8.0);
  std::vector<Vec3> way;
  for (int k = 0; k < 6; ++k) way.push_back({place(random), place(random), place(random)});
  return way;
}

}  // namespace

TEST_CASE(
    "20 hands wander for 20 s each round a bent way, as spring and as tube: no cut, and over each closed round the "
    "guide "
    "gives back less than half of the device's friction takes") {
  const std::uint32_t seed = 2014;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int round = 0; round < 20; ++round) {
    CAPTURE(round);
    GuidedLoop loop(guideInSpace(bentWay(random), round % 2 ? GuideKind::Spring : GuideKind::Tube, 1.0));
    // A sum of sines with whole periods in 20 s, so that the hand ends where it began.
    std::uniform_int_distribution<int> period(1, 12);
    std::uniform_real_distribution<double> size(4.0, 14.0), angle(0.0, 6.28);
    double turns[3][2], reach_mm[3][2], at[3][2];
    for (int axis = 0; axis < 3; ++axis)
      for (int k = 0; k < 2; ++k)
        turns[axis][k] = period(random), reach_mm[axis][k] = size(random), at[axis][k] = angle(random);
    const auto hand = [&](double part) {
      Vec3 out(0.0);
      for (int axis = 0; axis < 3; ++axis)
        for (int k = 0; k < 2; ++k)
          out[axis] += reach_mm[axis][k] * std::sin(6.283185307179586 * turns[axis][k] * part + at[axis][k]);
      return out;
    };
    loop.place_mm = hand(0.0);
    for (int k = 0; k < 700; ++k) loop.tick(hand(0.0));
    loop.worked_J = 0.0;
    double length_mm = 0.0, most_N = 0.0;
    constexpr int kTicks = 20000;
    for (int k = 1; k <= kTicks; ++k) {
      const Vec3 before = loop.place_mm;
      loop.tick(hand(double(k) / kTicks));
      length_mm += glm::distance(before, loop.place_mm);
      most_N = std::max(most_N, glm::length(loop.force_N));
    }
    CHECK(loop.cut == 0);
    CHECK(most_N > 0.3);
    CHECK(most_N < kGuideMax_N + 1e-9);
    CHECK(loop.worked_J < 1e-3 * 0.5 * loop.info.friction_N * length_mm);
  }
}

TEST_CASE(
    "a limp hand 24 mm beside a way of 40 mm is drawn to it, never beyond it by more than 1 mm, and along it by less "
    "than 0.01 mm, at strengths of 1, 2/3 and 1/3") {
  for (const double strength : {1.0, 2.0 / 3.0, 1.0 / 3.0})
    for (const GuideKind kind : {GuideKind::Spring, GuideKind::Tube}) {
      CAPTURE(strength);
      // The way is 10 A long; its tube reaches 1 A, 4 mm, to the side.
      GuidedLoop loop(guideInSpace({{-5, 0, 0}, {5, 0, 0}}, kind, 1.0, strength));
      // A mass of 0.1 kg with the damping of a loose grip of 4 N s/m.
      Vec3 place_mm(2.0, 24.0, 0.0), speed(0.0);
      double lowest_mm = 24.0, before_J = 0.0;
      loop.place_mm = place_mm;
      for (int k = 0; k < 8000; ++k) {
        loop.tick(place_mm);
        speed += (loop.force_N - 4.0 * speed) * (kTick_s / 0.1);
        place_mm += 1e3 * kTick_s * speed;
        lowest_mm = std::min(lowest_mm, place_mm.y);
        before_J = std::max(before_J, 0.05 * glm::dot(speed, speed));
      }
      CHECK(loop.cut == 0);
      CHECK(std::abs(place_mm.x - 2.0) < 0.01);
      CHECK(std::abs(place_mm.z) < 0.01);
      CHECK(place_mm.y < (kind == GuideKind::Tube ? 4.5 : 1.0));
      CHECK(lowest_mm > -1.0 - (kind == GuideKind::Spring ? 1.0 : 0.0));
      CHECK(glm::length(speed) < 1e-3);
      // It never had more energy than the potential at the start: 0.8 N over 24 mm.
      CHECK(before_J < 1e-3 * strength * kGuideMax_N * 24.0);
    }
}

TEST_CASE(
    "a guide begins softly: 0 N in the first tick, full force after 0.5 s; with the force switched off it gives none") {
  GuidedLoop loop(guideInSpace({{-5, 0, 0}, {5, 0, 0}}, GuideKind::Spring, 1.0));
  CHECK(glm::length(loop.tick({0, 20, 0}).force.N) < 0.01);
  for (int k = 0; k < 250; ++k) loop.tick({0, 20, 0});
  CHECK(glm::length(loop.force_N) == doctest::Approx(0.5 * kGuideMax_N).epsilon(0.05));
  for (int k = 0; k < 300; ++k) loop.tick({0, 20, 0});
  CHECK(glm::distance(loop.force_N, Vec3(0, -kGuideMax_N, 0)) < 1e-9);
  loop.settings.force_on = false;
  for (int k = 0; k < 20; ++k) loop.tick({0, 20, 0});
  CHECK(loop.force_N == Vec3(0.0));
}

TEST_CASE("a guide 100 times as stiff as the device bears is scaled to half of the stiffness bound") {
  Guide stiff = guideInSpace({{-5, 0, 0}, {5, 0, 0}}, GuideKind::Spring, 1.0);
  stiff.stiffness_N_per_A *= 100.0;
  GuidedLoop loop(std::move(stiff));
  ServoSample last;
  for (int k = 0; k < 700; ++k) last = loop.tick({0, 0.05, 0});
  CHECK(last.field_share < 0.5);
  CHECK(last.field_share * 100.0 * kGuideStiffness_N_per_mm ==
        doctest::Approx(0.5 * last.stiffness_bound_N_per_mm).epsilon(1e-6));
}
