// A scene whose spheres move while they are touched, on a virtual clock: the force goes on from frame to frame, the
// surface's own work is no energy that the loop made, and frames cross to the ticks in order.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "engine/haptics/methods.h"
#include "engine/haptics/sphere_motion.h"
#include "engine/servo/servo_loop.h"
#include "engine/servo/servo_step.h"
#include "tests/haptics/walk.h"

using namespace moltact;

namespace {

using Frame = std::shared_ptr<const SphereMotion>;

Frame frame(const std::vector<Sphere>& from, const std::vector<Sphere>& to, int ticks = 33) {
  auto made = SphereMotion::make(from, to, ticks);
  REQUIRE(made);
  return *std::move(made);
}
Frame after(const SphereMotion& before, const std::vector<Sphere>& to, int ticks = 33) {
  auto made = SphereMotion::after(before, to, ticks);
  REQUIRE(made);
  return *std::move(made);
}

// A hand that stands still at a height over the sphere in the origin, on a device that is as stiff as needed.
struct StillHand {
  explicit StillHand(const std::vector<Sphere>& spheres, std::string_view method = "exact")
      : felt(findMethod(method)->make(test::makeScene(spheres), kWaterProbe_A)) {}

  ServoSample tick(double z_mm, const MotionPhase& phase = {}) {
    return step.tick(settings, felt.get(), {.position = {{0, 0, z_mm}}}, {}, phase);
  }
  ServoSample press(double from_mm, double to_mm, int ticks = 700) {
    for (double z = from_mm; z > to_mm; z -= 0.2) tick(z);
    ServoSample last;
    for (int k = 0; k < ticks; ++k) last = tick(to_mm);
    return last;
  }
  static DeviceInfo deviceInfo() {
    DeviceInfo info{shownForceFigures()};
    info.gives_force = true;
    return info;
  }

  ServoSettings settings;
  ServoStep step{deviceInfo()};
  std::unique_ptr<Interaction> felt;
};

}  // namespace

TEST_CASE(
    "a hand that presses with 0.505 N feels 0.505 N in each of 330 ticks over ten frames that move nothing near it") {
  // At 0.25 A a mm the surface is 12 mm up, and 0.5 N/mm give 0.505 N at 10.99 mm. The other sphere is 9 A below.
  std::vector<Sphere> spheres{{{0, 0, 0}, 1.6}, {{0, 0, -9}, 1.6}};
  StillHand hand(spheres);
  REQUIRE(glm::length(hand.press(14, 10.99).force.N) == doctest::Approx(0.505).epsilon(1e-9));
  std::vector<Frame> frames;
  for (int k = 0; k < 10; ++k) {
    std::vector<Sphere> to = spheres;
    to[1].centre_A.x = 0.5 * (k + 1);
    frames.push_back(frames.empty() ? frame(spheres, to) : after(*frames.back(), to));
    for (int tick = 1; tick <= 33; ++tick) {
      const ServoSample s = hand.tick(10.99, {frames.back().get(), tick / 33.0});
      REQUIRE(s.force.N.z == doctest::Approx(0.505).epsilon(1e-9));
      REQUIRE_FALSE(s.limits.any());
      REQUIRE(s.motion == frames.back()->serial());
    }
  }
}

TEST_CASE(
    "a ball that rises by 0.4 A in ten frames raises the force on a still hand evenly by 0.8 N, and no limit acts") {
  std::vector<Sphere> spheres{{{0, 0, 0}, 1.6}};
  for (const std::string_view method : {"exact", "penalty"}) {
    CAPTURE(method);
    StillHand hand(spheres, method);
    hand.press(14, 11.5);
    std::vector<Frame> frames;
    double last_N = 0.25;
    for (int k = 0; k < 10; ++k) {
      std::vector<Sphere> to{{{0, 0, 0.04 * (k + 1)}, 1.6}};
      frames.push_back(frames.empty() ? frame(spheres, to) : after(*frames.back(), to));
      for (int tick = 1; tick <= 33; ++tick) {
        const ServoSample s = hand.tick(11.5, {frames.back().get(), tick / 33.0});
        REQUIRE_FALSE(s.limits.any());
        REQUIRE(s.force.N.z - last_N == doctest::Approx(0.8 / 330).epsilon(1e-6));
        last_N = s.force.N.z;
      }
    }
    CHECK(last_N == doctest::Approx(1.05).epsilon(1e-9));
    CHECK(hand.step.safety().debt_J() < 1e-12);
  }
}

TEST_CASE(
    "a probe that grows from 1.4 to 2.6 A under a still hand, and shrinks again, is no energy made: 0 J of debt") {
  StillHand hand({{{0, 0, 0}, 1.6}});
  hand.press(14, 11.5);
  bool cut = false, grown = false;
  double debt_J = 0.0;
  for (const double goal_A : {2.6, 1.4, 2.6}) {
    hand.settings.probe_A = goal_A;
    for (int k = 0; k < 400; ++k) {
      const ServoSample s = hand.tick(11.5);
      cut = cut || s.limits.has(Limit::EnergyCut) || s.limits.has(Limit::Damping);
      grown = grown || s.probe_A > 2.59;
      debt_J = std::max(debt_J, hand.step.safety().debt_J());
    }
  }
  CHECK(grown);
  CHECK_FALSE(cut);
  CHECK(debt_J < 1e-12);
}

TEST_CASE("energy that a method makes is still a debt while the surface moves: a wall twice as stiff on the way out") {
  // The same sphere grows all the while; the hand goes 2 mm in and out, and on the way out twice the force is wanted.
  class Dishonest final : public Tracker {
   public:
    explicit Dishonest(std::unique_ptr<Tracker> of) : of_(std::move(of)) {}
    Contact step(PointA hip) noexcept override {
      Contact c = of_->step(hip);
      if (out) c.displacement_A *= 2.0;
      return c;
    }
    void reset() noexcept override { of_->reset(); }
    void setProbe(double probe_A) noexcept override { of_->setProbe(probe_A); }
    double probe_A() const noexcept override { return of_->probe_A(); }
    MemoryUsage memoryUsage() const noexcept override { return of_->memoryUsage(); }
    bool setMotion(const SphereMotion* f) noexcept override { return of_->setMotion(f); }
    void advanceTo(double fraction) noexcept override { of_->advanceTo(fraction); }
    bool out = false;

   private:
    std::unique_ptr<Tracker> of_;
  };
  const std::vector<Sphere> spheres{{{0, 0, 0}, 1.6}};
  for (const bool dishonest : {false, true}) {
    CAPTURE(dishonest);
    StillHand hand(spheres);
    auto felt = std::make_unique<Dishonest>(findMethod("exact")->make(test::makeScene(spheres), kWaterProbe_A));
    Dishonest& method = *felt;
    hand.felt = std::move(felt);
    hand.press(14, 11.5);
    const Frame grows = frame(spheres, {{{0, 0, 0}, 1.8}}, 2000);
    double debt_J = 0.0;
    for (int k = 1; k <= 2000; ++k) {
      const double phase = 2.0 * 3.14159265358979 * k / 500.0;
      method.out = dishonest && std::sin(phase) < 0.0;
      hand.tick(10.5 + std::cos(phase), {grows.get(), k / 2000.0});
      debt_J = std::max(debt_J, hand.step.safety().debt_J());
    }
    // 2 mm at 0.5 N/mm hold 1 mJ, of which half more comes out than went in, less what the device's friction takes.
    if (dishonest)
      CHECK(debt_J > 2e-4);
    else
      CHECK(debt_J < 2e-5);
  }
}

TEST_CASE("frames handed over as fast as they are taken begin one after the other, and none is left out or cut short") {
  struct Still final : Device {
    DeviceInfo is{shownForceFigures()};
    const DeviceInfo& info() const noexcept override { return is; }
    DevicePose read(double) noexcept override { return {.position = {{0, 0, 20}}}; }
    void write(ForceN) noexcept override {}
  } hand;
  std::vector<Sphere> spheres{{{0, 0, 0}, 1.6}};
  ServoLoop loop(hand);
  loop.begin(0);
  loop.setInteraction(findMethod("exact")->make(test::makeScene(spheres), kWaterProbe_A), 7);
  std::vector<std::uint64_t> serials;
  std::vector<Frame> kept;
  Frame next = frame(spheres, {{{0, 0, 0.01}, 1.6}}, 10);
  std::vector<ServoSample> all;
  for (int k = 0; k < 200; ++k) {
    if (loop.setMotion(next, 7)) {
      serials.push_back(next->serial());
      kept.push_back(next);
      next = after(*kept.back(), {{{0, 0, 0.01 * double(kept.size() + 1)}, 1.6}}, 10);
      CHECK_FALSE(loop.setMotion(next, 7));  // one waits already
    }
    loop.tick((k + 1) * ServoLoop::kPeriod_ns, std::nullopt, nullptr);
    loop.drain([&](const ServoSample& s) { all.push_back(s); });
  }
  REQUIRE(all.size() == 200);
  for (std::size_t k = 0; k < all.size(); ++k) {
    CAPTURE(k);
    REQUIRE(k / 10 < serials.size());
    REQUIRE(all[k].motion == serials[k / 10]);
    REQUIRE(all[k].fraction == doctest::Approx(0.1 * double(k % 10 + 1)));
  }
}

TEST_CASE(
    "two walls of balls that close on a hand between them in 2 s, as a molecule's lid does, and go through it, never "
    "give "
    "more than the device's force nor change it by more than 1000 N/s") {
  std::vector<Sphere> open, shut;
  for (int x = -3; x <= 3; ++x)
    for (int y = -3; y <= 3; ++y)
      for (const double side : {-1.0, 1.0}) {
        open.push_back({{2.0 * x, 2.0 * y, 8.0 * side}, 1.6});
        shut.push_back({{2.0 * x, 2.0 * y, 0.8 * side}, 1.6});
      }
  for (const std::string_view method : {"exact", "penalty", "mesh960"}) {
    CAPTURE(method);
    StillHand hand(open, method);
    const double max_N = StillHand::deviceInfo().max_force_N;
    for (int k = 0; k < 1500; ++k) hand.tick(1.0);  // soft start, in the open between them
    Frame last;
    Vec3 before(0.0);
    double peak_N = 0.0;
    for (int k = 1; k <= 60; ++k) {
      std::vector<Sphere> to = open;
      for (std::size_t i = 0; i < to.size(); ++i)
        to[i].centre_A += (shut[i].centre_A - open[i].centre_A) * (double(k) / 60.0);
      Frame next = last ? after(*last, to) : frame(open, to);
      for (int tick = 1; tick <= 33; ++tick) {
        const ServoSample s = hand.tick(1.0, {next.get(), tick / 33.0});
        REQUIRE(finite(s.force.N));
        const double force_N = glm::length(s.force.N);
        peak_N = std::max(peak_N, force_N);
        REQUIRE(force_N <= max_N + 1e-9);
        REQUIRE(glm::distance(s.force.N, before) <= 1.0 + 1e-9);
        before = s.force.N;
      }
      last = std::move(next);
    }
    CHECK(peak_N > 0.3);  // it was felt
    ServoSample rest;
    for (int k = 0; k < 1000; ++k) rest = hand.tick(1.0, {last.get(), 1.0});
    CHECK(glm::length(rest.force.N) <= max_N + 1e-9);
  }
}

TEST_CASE(
    "a frame waits for its scene, another method of the scene takes it over, and another scene does not know it") {
  struct Pressing final : Device {
    DeviceInfo is{shownForceFigures()};
    const DeviceInfo& info() const noexcept override { return is; }
    DevicePose read(double) noexcept override { return {.position = {{0, 0, 20}}}; }
    void write(ForceN) noexcept override {}
  } hand;
  const std::vector<Sphere> spheres{{{0, 0, 0}, 1.6}};
  const auto make = [&] { return findMethod("exact")->make(test::makeScene(spheres), kWaterProbe_A); };
  ServoLoop loop(hand);
  loop.begin(0);
  std::int64_t now_ns = 0;
  const auto tick = [&](int times) {
    for (int k = 0; k < times; ++k) loop.tick(now_ns += ServoLoop::kPeriod_ns, std::nullopt, nullptr);
    return loop.latest();
  };
  loop.setInteraction(make(), 1);
  const Frame first = frame(spheres, {{{0, 0, 1}, 1.6}}, 20);
  REQUIRE(loop.setMotion(first, 2));
  CHECK(tick(5).motion == 0);  // scene 1 is felt
  loop.setInteraction(make(), 2);
  CHECK(tick(10).motion == first->serial());
  CHECK(loop.latest().fraction == doctest::Approx(0.5));
  loop.setInteraction(make(), 2);
  CHECK(tick(5).fraction == doctest::Approx(0.75));
  CHECK(tick(30).fraction == 1.0);  // it stays
  const Frame other = frame(spheres, {{{0, 1, 0}, 1.6}}, 20);
  REQUIRE(loop.setMotion(other, 3));
  CHECK(tick(3).motion == first->serial());  // the other scene's waits
  CHECK(loop.latest().fraction == 1.0);
  loop.setInteraction(make(), 3);
  CHECK(tick(1).motion == other->serial());
  CHECK(loop.latest().fraction == doctest::Approx(0.05));
  loop.drain([](const ServoSample&) {});
  CHECK(first.use_count() == 1);  // given back, and destroyed here
}
