// The servo loop's logic on a virtual clock: every tick is a call, which advances the time.
#include "engine/servo/servo_step.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "engine/bench/scenes.h"
#include "engine/haptics/methods.h"
#include "tests/haptics/walk.h"

using namespace moltact;

namespace {

std::unique_ptr<Tracker> oneSphere() {  // 1.6 A at the origin
  return methods().front().make(test::makeScene({{{0, 0, 0}, 1.6}}), kWaterProbe_A);
}

// A servo loop whose hand is led at 0.5 m/s, as a hand moves.
class Loop {
 public:
  explicit Loop(Vec3 start_mm) : hand_mm_(start_mm) {}
  ServoSettings settings;

  ServoSample tick(Tracker* tracker, DevicePose pose) { return step_.tick(settings, tracker, pose); }

  /// Leads the hand there and holds it still for `ticks` ticks.
  ServoSample hold(Tracker* tracker, Vec3 to_mm, int ticks) {
    constexpr double kStep_mm = 0.5;
    ServoSample last;
    while (hand_mm_ != to_mm) {
      const Vec3 way = to_mm - hand_mm_;
      hand_mm_ = glm::length(way) <= kStep_mm ? to_mm : hand_mm_ + way * (kStep_mm / glm::length(way));
      last = tick(tracker, {.position = {hand_mm_}});
    }
    for (int k = 0; k < ticks; ++k) last = tick(tracker, {.position = {hand_mm_}});
    return last;
  }

 private:
  ServoStep step_;
  Vec3 hand_mm_;
};

}  // namespace

TEST_CASE("pressing 1 mm into a wall of 0.5 N/mm gives 0.5 N outward once the soft start is over") {
  auto tracker = oneSphere();
  Loop loop({0, 0, 20});  // 0.25 A a mm: the surface at 3 A lies at 12 mm
  const ServoSample s = loop.hold(tracker.get(), {0, 0, 11}, 600);
  CHECK(s.contact.feature == Feature::Sphere);
  CHECK(s.force.N.z == doctest::Approx(0.5).epsilon(1e-12));
  CHECK(std::abs(s.force.N.x) + std::abs(s.force.N.y) < 1e-12);
  CHECK_FALSE(s.limits.any());
}

TEST_CASE("with the device turned by 90 degrees the force is turned with it") {
  auto tracker = oneSphere();
  Loop loop({20, 0, 0});
  loop.settings.workspace.rotation =
      glm::dmat3(Vec3(0, 1, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1));  // device x is the molecule's y
  const ServoSample s = loop.hold(tracker.get(), {11, 0, 0}, 600);
  CHECK(s.hip.A.y == doctest::Approx(2.75));
  CHECK(s.force.N.x == doctest::Approx(0.5).epsilon(1e-12));
}

TEST_CASE("a force of 10 mm x 0.5 N/mm is clamped to 3.3 N, keeps its direction and says so") {
  auto tracker = oneSphere();
  Loop loop({0, 12, 16});
  const ServoSample s = loop.hold(tracker.get(), {0, 1.2, 1.6}, 600);
  CHECK(glm::length(s.force.N) == doctest::Approx(3.3).epsilon(1e-12));
  CHECK(s.force.N.y / s.force.N.z == doctest::Approx(0.75).epsilon(1e-9));
  CHECK(s.limits.has(Limit::Clamp));
}

TEST_CASE("after a start the force grows by at most 3.3 N x 1 ms / 500 ms a tick") {
  auto tracker = oneSphere();
  Loop loop({0, 0, 12.5});
  loop.hold(tracker.get(), {0, 0, 12}, 1);
  double last = 0;
  int softly = 0;
  Vec3 hand(0, 0, 12);
  for (int k = 0; k < 700; ++k) {
    hand.z = std::max(2.0, hand.z - 0.9);
    const ServoSample s = loop.tick(tracker.get(), {.position = {hand}});
    const double now = glm::length(s.force.N);
    if (now - last > 0.0066 + 1e-12)
      CHECK(hand.z > 2.0);  // while the hand still moves, the spring's own growth counts too
    CHECK(now <= 3.3 * (k + 6) / 500.0);
    softly += s.limits.has(Limit::SoftStart);
    last = now;
  }
  CHECK(softly == doctest::Approx(498).epsilon(0.004));
  CHECK(last == doctest::Approx(3.3));
}

TEST_CASE("a new tracker under the hand gives no force: the HIP starts inside until it has been outside") {
  auto first = oneSphere(), second = oneSphere();
  Loop loop({0, 0, 20});
  CHECK(glm::length(loop.hold(first.get(), {0, 0, 10}, 600).force.N) > 0.9);
  const ServoSample swapped = loop.hold(second.get(), {0, 0, 10}, 600);
  CHECK(swapped.contact.fault == Fault::StartedInside);
  CHECK(swapped.force.N == Vec3(0));
  loop.hold(second.get(), {0, 0, 20}, 10);
  CHECK(glm::length(loop.hold(second.get(), {0, 0, 10}, 600).force.N) == doctest::Approx(1.0));
}

TEST_CASE("without a tracker, with the force off, and for a NaN from the device the force is zero within 4 ms") {
  auto tracker = oneSphere();
  Loop loop({0, 0, 20});
  CHECK(loop.hold(nullptr, {0, 0, 20}, 5).force.N == Vec3(0));
  CHECK(glm::length(loop.hold(tracker.get(), {0, 0, 10}, 600).force.N) == doctest::Approx(1.0));
  ServoSample bad;
  for (int k = 0; k < 4; ++k) bad = loop.tick(tracker.get(), {.position = {{std::nan(""), 0, 0}}});
  CHECK(bad.contact.fault == Fault::NotFinite);
  CHECK(bad.force.N == Vec3(0));
  CHECK(bad.limits.has(Limit::NotFinite));
  CHECK(glm::length(loop.hold(tracker.get(), {0, 0, 10}, 1).force.N) < 0.01);  // it comes back softly
  loop.hold(tracker.get(), {0, 0, 10}, 600);
  loop.settings.force_on = false;
  const ServoSample off = loop.hold(tracker.get(), {0, 0, 10}, 4);
  CHECK(off.contact.touching());
  CHECK(off.force.N == Vec3(0));
}

TEST_CASE("settings that are not finite or out of range give no force beyond the clamp and no NaN") {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, inf, -inf, -1.0, 1e300}) {
    CAPTURE(bad);
    auto tracker = oneSphere();
    Loop loop({0, 0, 20});
    loop.hold(tracker.get(), {0, 0, 20}, 600);
    loop.settings.stiffness_N_per_mm = bad;
    loop.settings.probe_A = bad;
    loop.settings.max_force_N = bad;
    const ServoSample s = loop.hold(tracker.get(), {0, 0, 10}, 600);
    CHECK(finite(s.force.N));
    CHECK(glm::length(s.force.N) <= 3.3 + 1e-12);
  }
}

TEST_CASE("a new probe radius is reached at 8 A/s: from 1.4 to 2.2 A in 100 ticks, under the hand, without a leap") {
  auto tracker = oneSphere();
  Loop loop({0, 0, 20});
  double last = loop.hold(tracker.get(), {0, 0, 11}, 600).force.N.z;
  loop.settings.probe_A = 2.2;
  for (int k = 0; k < 100; ++k) {
    const ServoSample s = loop.hold(tracker.get(), {0, 0, 11}, 1);
    CHECK(s.force.N.z - last == doctest::Approx(0.008 / 0.25 * 0.5).epsilon(1e-6));  // 8 um of surface at 0.25 A a mm
    last = s.force.N.z;
  }
  CHECK(tracker->probe_A() == doctest::Approx(2.2));
}

TEST_CASE("the same hand gives the same forces to the last bit, over 20 000 ticks on 50 random spheres") {
  const scenes::Scene scene = scenes::cluster(50, 9);
  const scenes::Path path = scenes::walk(scene, 20'000, 10);
  const auto run = [&] {
    auto tracker = methods().front().make(test::makeScene(scene.spheres), scene.probe_A);
    ServoStep step;
    const ServoSettings settings;
    std::vector<Vec3> forces;
    for (const Vec3& hip : path)
      forces.push_back(step.tick(settings, tracker.get(), {.position = settings.workspace.toDevice({hip})}).force.N);
    return forces;
  };
  CHECK(run() == run());
}
