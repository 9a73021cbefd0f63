// Each limit of the safety stage separately, against its closed form. Every tick is a call with its own time.
#include "engine/servo/safety_stage.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace moltact;

namespace {

DeviceInfo omni() {
  DeviceInfo info{phantomOmniFigures(), "Omni"};
  info.gives_force = true;
  return info;
}

WantedWrench push(double z_N) { return {.force_N = {0, 0, z_N}}; }

// A stage past its soft start, the hand at the origin.
SafetyStage ready(const DeviceInfo& info = omni()) {
  SafetyStage stage(info);
  for (int k = 0; k < 600; ++k) {
    stage.beginTick({}, {});
    stage.output(push(0));
  }
  return stage;
}

ForceN tick(SafetyStage& stage, const WantedWrench& wanted, const DevicePose& pose = {}, const TickTime& time = {}) {
  stage.beginTick(pose, time);
  return stage.output(wanted).force;
}

// The force after `ticks` ticks of the same.
double after(SafetyStage& stage, int ticks, const WantedWrench& wanted, const DevicePose& pose = {},
             const TickTime& time = {}) {
  ForceN last;
  for (int k = 0; k < ticks; ++k) last = tick(stage, wanted, pose, time);
  return last.N.z;
}

}  // namespace

TEST_CASE("slew: a force of 3 N asked at once comes as 1, 2 and 3 N in three ticks, and goes as it came") {
  SafetyStage stage = ready();
  for (const double want : {1.0, 2.0, 3.0}) {
    CHECK(tick(stage, push(3)).N.z == doctest::Approx(want));
    CHECK(stage.acted().has(Limit::Slew) == (want < 3));
  }
  for (const double want : {2.0, 1.0, 0.0}) CHECK(tick(stage, push(0)).N.z == doctest::Approx(want));
}

TEST_CASE("slew: a tick that comes twice within no time changes nothing, one that is 5 ms late no more than 1 N") {
  SafetyStage stage = ready();
  CHECK(tick(stage, push(3), {}, {.dt_s = 0}).N.z == 0.0);
  CHECK(tick(stage, push(3), {}, {.dt_s = 0.005}).N.z == doctest::Approx(1.0));
}

TEST_CASE("clamp: 5 N along (3, 4, 0) become 3.3 N along it; with 2 N allowed, 2 N") {
  SafetyStage stage = ready();
  ForceN force;
  for (int k = 0; k < 10; ++k) force = tick(stage, {.force_N = {3, 4, 0}});
  CHECK(force.N.x == doctest::Approx(3.3 * 0.6));
  CHECK(force.N.y == doctest::Approx(3.3 * 0.8));
  CHECK(stage.acted().has(Limit::Clamp));
  for (int k = 0; k < 10; ++k) force = tick(stage, {.force_N = {3, 4, 0}, .max_N = 2});
  CHECK(glm::length(force.N) == doctest::Approx(2.0));
}

TEST_CASE("not a number: NaN and infinite forces give none in the very tick, and the next begins softly") {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(), 1e200}) {
    CAPTURE(bad);
    SafetyStage stage = ready();
    REQUIRE(after(stage, 10, push(3)) == doctest::Approx(3.0));
    const ForceN force =
        tick(stage, {.force_N = {bad, 0, 0}, .stored = {.springs = {.stretch_mm = bad, .energy_mm2 = bad}}});
    if (bad == 1e200) continue;  // a number, though its square is none: what comes is bounded all the same
    CHECK(stage.acted().has(Limit::NotFinite));
    CHECK(glm::length(force.N) == 0.0);
    CHECK(tick(stage, push(3)).N.z <= 3.0 / 500 + 1e-12);
  }
}

TEST_CASE("heat: 3.3 N may be held for about 1.7 s, then the force falls to 0.88 N and never warms beyond it") {
  // The heat rises as 3.3^2 (1 - exp(-t/30 s)); at 0.8 x 0.88^2 the peak begins to fall.
  const double falls_s = -30 * std::log(1 - 0.8 * 0.88 * 0.88 / (3.3 * 3.3));
  SafetyStage stage = ready();
  double first_s = 0, force_N = 0, warmest = 0;
  for (int k = 0; k < 300'000; ++k) {
    force_N = tick(stage, push(3.3)).N.z;
    if (first_s == 0 && stage.acted().has(Limit::Heat)) first_s = k * 0.001;
    warmest = std::max(warmest, stage.heat());
  }
  CHECK(first_s == doctest::Approx(falls_s).epsilon(0.01));
  CHECK(force_N == doctest::Approx(0.88).epsilon(0.01));
  CHECK(warmest <= 1.0 + 1e-9);
  // After a minute's rest the peak is there again.
  after(stage, 60'000, push(0));
  CHECK(after(stage, 10, push(3.3)) == doctest::Approx(3.3));
}

TEST_CASE("heat: 0.8 N held for ten minutes is never cut") {
  SafetyStage stage = ready();
  bool cut = false;
  for (int k = 0; k < 600'000; ++k) {
    tick(stage, push(0.8));
    cut = cut || stage.acted().has(Limit::Heat);
  }
  CHECK_FALSE(cut);
}

TEST_CASE("watchdog: a stale place leaves the force for 20 ms, ends it by 44 ms, and forgets the contact at 100 ms") {
  SafetyStage stage = ready();
  after(stage, 10, push(3));
  DevicePose stale;
  stale.fresh = false;
  for (int ms = 1; ms <= 150; ++ms) {
    CAPTURE(ms);
    const bool forget = stage.beginTick(stale, {});
    const double force = stage.output(push(3)).force.N.z;
    CHECK(forget == (ms == 100));
    if (ms <= 20) CHECK(force == doctest::Approx(3.0));
    if (ms >= 44) CHECK(force == 0.0);
    if (ms > 20 && ms < 100) CHECK(stage.acted().has(Limit::StalePlace));
  }
  CHECK(stage.beginTick({}, {}));  // it is back, and may be anywhere
  CHECK(stage.output(push(3)).force.N.z <= 3.0 / 500 + 1e-12);
}

TEST_CASE(
    "late loop: a clock that stood for 21 ms, ran back or is no number ends the force in the very tick and restarts "
    "softly") {
  for (const double dt_s : {0.021, 5.0, -0.001, -1e9, std::nan(""), std::numeric_limits<double>::infinity()}) {
    CAPTURE(dt_s);
    SafetyStage stage = ready();
    after(stage, 10, push(3));
    const bool forget = stage.beginTick({}, {.dt_s = dt_s});
    CHECK(forget == (dt_s > 0.1));
    CHECK(stage.acted().has(Limit::LateLoop));
    CHECK(stage.output(push(3)).force.N.z == 0.0);
    CHECK(after(stage, 3, push(3)) <= 3 * 3.0 / 500 + 1e-12);
    CHECK(after(stage, 500, push(3)) == doctest::Approx(3.0));
  }
}

TEST_CASE("jump: 6 mm in a tick forget the contact, 4 mm do not; nor do 60 mm after 15 ms without a place") {
  SafetyStage stage = ready();
  after(stage, 10, push(1));
  CHECK_FALSE(stage.beginTick({.position = {{4, 0, 0}}}, {}));
  stage.output(push(1));
  CHECK(stage.beginTick({.position = {{10, 0, 0}}}, {}));
  CHECK(stage.acted().has(Limit::Jump));
  CHECK(stage.output(push(1)).force.N.z == 0.0);
  for (int k = 0; k < 14; ++k) tick(stage, push(1), {.position = {{10, 0, 0}}, .fresh = false});
  CHECK_FALSE(stage.beginTick({.position = {{70, 0, 0}}}, {}));
  CHECK(stage.beginTick({.position = {{170, 0, 0}}}, {}));
  // repositioned: no displacement
  CHECK_FALSE(stage.beginTick({.position = {{-170, 0, 0}}, .discontinuities = 1}, {}));
}

TEST_CASE("unplugged: no force in the very tick, the contact forgotten when it goes and when it comes back") {
  SafetyStage stage = ready();
  after(stage, 10, push(3));
  DevicePose gone;
  gone.connected = false;
  CHECK(stage.beginTick(gone, {}));
  CHECK(stage.output(push(3)).force.N.z == 0.0);
  CHECK(after(stage, 3, push(3), gone) == 0.0);
  CHECK(stage.acted().has(Limit::Unplugged));
  CHECK(stage.beginTick({}, {}));
  CHECK(stage.output(push(3)).force.N.z <= 3.0 / 500 + 1e-12);
}

TEST_CASE(
    "another device: whatever the last one was given, it begins at nothing and softly, and the motors' heat is not "
    "forgotten") {
  DeviceInfo weak = omni();
  weak.max_force_N = 1.0;
  const DeviceInfo mouse{shownForceFigures()};
  for (const DeviceInfo* next : std::initializer_list<const DeviceInfo*>{&weak, &mouse}) {
    SafetyStage stage = ready();
    REQUIRE(after(stage, 1000, push(3.3)) == doctest::Approx(3.3));
    const double warm = stage.heat();
    REQUIRE(warm > 0.3);
    stage.setDevice(*next);
    double last_N = 0;
    for (int k = 1; k <= 500; ++k) {
      const double force_N = tick(stage, push(3.3)).N.z;
      CHECK(force_N <= next->max_force_N * k / 500 + 1e-9);
      CHECK(force_N >= last_N);
      last_N = force_N;
    }
    CHECK(last_N == doctest::Approx(next->max_force_N));
    // With the mouse no motor heats; the stylus returns almost as warm as before.
    stage.setDevice(omni());
    stage.beginTick({}, {});
    if (next == &mouse) CHECK(stage.heat() == doctest::Approx(warm * std::exp(-0.5 / 30)).epsilon(0.01));
    CHECK(glm::length(stage.output(push(3.3)).force.N) <= 3.3 / 500 + 1e-9);
  }
}

TEST_CASE(
    "speed: at 0.5 m/s the force stays, at 0.875 m/s half of what drives the hand, from 1 m/s nothing; what brakes "
    "stays") {
  for (const double speed : {0.5, 0.875, 1.0, 1.4}) {
    for (const double sign : {1.0, -1.0}) {
      CAPTURE(speed);
      CAPTURE(sign);
      DeviceInfo info = omni();
      info.gives_force = false;  // no braking on top
      SafetyStage stage = ready(info);
      Vec3 place(0.0);
      ForceN force;
      for (int k = 0; k < 40; ++k) {
        place.z += speed;
        force = tick(stage, {.force_N = {1, 0, 2 * sign}}, {.position = {place}});
      }
      const double driven = speed <= 0.75 ? 2 : speed >= 1 ? 0 : 1;
      CHECK(force.N.z == doctest::Approx(sign > 0 ? driven : -2));
      CHECK(force.N.x == doctest::Approx(1.0));
      CHECK(stage.acted().has(Limit::Speed) == (sign > 0 && speed > 0.75));
    }
  }
}

TEST_CASE(
    "a device's own limits are kept clear of by a tenth: of 0.5 m/s, nothing drives the hand from 0.45 m/s on; of 200 "
    "N/s, the force rises by "
    "0.18 N a tick and ends as fast as ever; without them, or where they are none, ours hold") {
  DeviceInfo slow = omni();
  slow.gives_force = false;  // no braking on top
  slow.speed_limit_m_per_s = 0.5;
  slow.slew_limit_N_per_s = 200;
  SafetyStage stage = ready(slow);
  CHECK(tick(stage, push(3)).N.z == doctest::Approx(0.18));
  CHECK(tick(stage, push(3)).N.z == doctest::Approx(0.36));
  CHECK(after(stage, 20, push(3)) == doctest::Approx(3.0));
  for (const double want : {2.0, 1.0, 0.0}) CHECK(tick(stage, push(0)).N.z == doctest::Approx(want));
  after(stage, 20, push(2));
  Vec3 at(0.0);
  ForceN force;
  for (int k = 0; k < 20; ++k) force = tick(stage, push(2), {.position = {at += Vec3(0, 0, 0.45)}});
  CHECK(force.N.z == doctest::Approx(0.0));
  CHECK(stage.acted().has(Limit::Speed));
  for (int k = 0; k < 20; ++k) force = tick(stage, push(2), {.position = {at += Vec3(0, 0, 0.3)}});
  CHECK(force.N.z == doctest::Approx(2.0));
  for (const double none : {0.0, -1.0, std::nan(""), DeviceSpecs::kNoLimit}) {
    CAPTURE(none);
    DeviceInfo figures = omni();
    figures.speed_limit_m_per_s = figures.slew_limit_N_per_s = none;
    SafetyStage ours = ready(figures);
    CHECK(tick(ours, push(3)).N.z == doctest::Approx(1.0));
  }
}

TEST_CASE(
    "stiffness: with 2.2 N s/m and 1 ms of delay 0.73 N/mm are stable by half, with 3 ms 0.31, and it is reached "
    "slowly") {
  SafetyStage stage = ready();
  CHECK(stage.stiffnessBound_N_per_mm() == doctest::Approx(0.5 * 2.2 / 1.5));
  CHECK(stage.stiffness(0.5) == 0.5);
  CHECK_FALSE(stage.acted().has(Limit::Stiffness));
  CHECK(stage.stiffness(2.0) == doctest::Approx(0.5 * 2.2 / 1.5));
  CHECK(stage.acted().has(Limit::Stiffness));
  stage.output({.force_N = {0, 0, 1},
                .stored = {.springs = {.stretch_mm = 1.4, .energy_mm2 = 0.98}},
                .stiffness_N_per_mm = 0.733});  // now it is felt
  stage.beginTick({}, {.delay_s = 0.002});
  CHECK(stage.stiffnessBound_N_per_mm() == doctest::Approx(0.5 * 2.2 / 3.5));
  CHECK(stage.stiffness(2.0) == doctest::Approx(0.5 * 2.2 / 1.5 - 0.001));
  SafetyStage aged = ready();
  aged.beginTick({.position = {}, .age_s = 0.002f}, {});
  CHECK(aged.stiffnessBound_N_per_mm() == doctest::Approx(0.5 * 2.2 / 3.5));
  aged.beginTick({.position = {}, .age_s = std::nanf("")}, {});
  CHECK(aged.stiffnessBound_N_per_mm() < 0.012);
  DeviceInfo coarse = omni();
  coarse.resolution_mm = 2.0;  // 2 x 0.26 N / 2 mm = 0.26 N/mm
  CHECK(ready(coarse).stiffnessBound_N_per_mm() == doctest::Approx(0.13));
  coarse.friction_N = 0.0;  // not known: 2 x 0.01 N / 2 mm
  CHECK(ready(coarse).stiffnessBound_N_per_mm() == doctest::Approx(0.005));
}

TEST_CASE(
    "a device of which its driver names too little gets less: no force at all without both forces, with both at most "
    "0.1 N/mm for an unknown friction and step of the place, and no figure left out gives more than naming it") {
  DeviceInfo named = omni();
  for (double DeviceSpecs::*left_out : {&DeviceSpecs::max_force_N, &DeviceSpecs::continuous_force_N}) {
    DeviceInfo info = named;
    info.*left_out = DeviceSpecs().*left_out;
    SafetyStage stage = ready(info);
    for (int k = 0; k < 2000; ++k) CHECK(tick(stage, push(3)).N == Vec3(0.0));
  }
  DeviceInfo bare;
  bare.gives_force = true;
  bare.max_force_N = 3.3, bare.continuous_force_N = 0.88;
  // 2 x 0.01 N / 0.1 mm, half of it.
  CHECK(ready(bare).stiffnessBound_N_per_mm() == doctest::Approx(0.1));
  SafetyStage forces = ready(bare);
  CHECK(after(forces, 10, push(3)) == doctest::Approx(3.0));
  const double bound = ready(named).stiffnessBound_N_per_mm();
  for (double DeviceSpecs::*left_out : {&DeviceSpecs::max_stiffness_N_per_mm, &DeviceSpecs::damping_N_s_per_m,
                                        &DeviceSpecs::friction_N, &DeviceSpecs::resolution_mm, &DeviceSpecs::delay_s}) {
    DeviceInfo info = named;
    info.*left_out = DeviceSpecs().*left_out;
    CHECK(ready(info).stiffnessBound_N_per_mm() <= bound);
  }
}

TEST_CASE(
    "springs that pull together share the bound: of 0.73 N/mm four have 0.18 each, at once when they come and no "
    "faster than 1 N/mm a second when they go; where they need less, and without a loop, each keeps what is asked") {
  const double bound = 0.5 * 2.2 / 1.5;
  SafetyStage stage = ready();
  const auto felt = [&](double stiffness) {
    stage.beginTick({}, {});
    stage.output({.force_N = {0, 0, 1},
                  .stored = {.springs = {.stretch_mm = 2.0, .energy_mm2 = 2.0}},
                  .stiffness_N_per_mm = stiffness});
    stage.beginTick({}, {});
  };
  CHECK(stage.stiffness(0.5, {.stiffness_factor = 1.0}) == 0.5);
  felt(0.5);
  CHECK(stage.stiffness(0.5, {.stiffness_factor = 1.4}) == 0.5);  // 0.7 N/mm together
  CHECK_FALSE(stage.acted().has(Limit::Stiffness));
  CHECK(stage.stiffness(0.5, {.stiffness_factor = 4.0}) == doctest::Approx(bound / 4));
  CHECK(stage.acted().has(Limit::Stiffness));
  felt(bound / 4);
  CHECK(stage.stiffness(0.5, {.stiffness_factor = 1.0}) == doctest::Approx(bound / 4 + 0.001));
  CHECK(stage.stiffness(0.5, {.stiffness_factor = std::nan("")}) == 0.0);
  SafetyStage mouse = ready(DeviceInfo{shownForceFigures()});
  CHECK(mouse.stiffness(0.5, {.stiffness_factor = 40.0}) == 0.5);
}

TEST_CASE(
    "device: while it reports a fault there is no force from that tick on, and its own heat of 0.9 halves what the "
    "peak has over the continuous force") {
  SafetyStage stage = ready();
  after(stage, 10, push(3));
  DevicePose pose;
  pose.fault = true;
  CHECK(tick(stage, push(3), pose).N.z == 0.0);
  CHECK(stage.acted().has(Limit::DeviceFault));
  CHECK_FALSE(stage.beginTick({}, {}));  // the place was known all the while
  stage = ready();
  pose.fault = false;
  pose.motor_heat = 0.9f;
  CHECK(after(stage, 10, push(3.3), pose) == doctest::Approx(0.88 + 0.5 * (3.3 - 0.88)).epsilon(1e-6));
  pose.motor_heat = std::nanf("");
  CHECK(after(stage, 10, push(3.3), pose) == doctest::Approx(0.88));
}

TEST_CASE(
    "what is switched off, another scene and another scale go along the slew: 3 N are 2, 1 and 0 N in the next three "
    "ticks") {
  SafetyStage off = ready(), other = ready();
  after(off, 10, push(3));
  after(other, 10, push(3));
  WantedWrench none = push(3);
  none.on = false;
  other.restart();
  for (int k = 1; k <= 3; ++k) {
    CAPTURE(k);
    CHECK(tick(off, none).N.z == doctest::Approx(3.0 - k));
    CHECK(tick(other, push(3)).N.z == doctest::Approx(3.0 - k).epsilon(0.03));
  }
}

TEST_CASE("panic: no force in the very tick, as long as it lasts, and a soft start after it") {
  SafetyStage stage = ready();
  after(stage, 10, push(3));
  stage.stop(true);
  CHECK(tick(stage, push(3)).N.z == 0.0);
  CHECK(stage.acted().has(Limit::Panic));
  CHECK(after(stage, 1000, push(3)) == 0.0);
  stage.stop(false);
  CHECK(tick(stage, push(3)).N.z <= 3.0 / 500 + 1e-12);
}

TEST_CASE(
    "damping: of a wall that pushes twice as hard on the way out as on the way in a hand gets less than two thirds; an "
    "honest one is left alone") {
  for (const bool dishonest : {false, true}) {
    CAPTURE(dishonest);
    SafetyStage stage = ready();
    LimitFlags acted;
    double given_J = 0, unlimited_J = 0, last_mm = 0;
    Vec3 last(0.0), asked(0.0);
    for (int k = 0; k < 4000; ++k) {  // in and out by 1 mm at 5 Hz: at most 31 mm/s
      const double phase = k * 0.005 * 6.283185307, z_mm = -1 + std::cos(phase);
      given_J += last.z * 1e-3 * (z_mm - last_mm);
      unlimited_J += asked.z * 1e-3 * (z_mm - last_mm);
      last_mm = z_mm;
      const double stretch_mm = -z_mm * (dishonest && std::sin(phase) < 0 ? 2 : 1);
      asked = {0, 0, 0.5 * stretch_mm};
      last = tick(stage,
                  {.force_N = asked,
                   .stored = {.springs = {.stretch_mm = stretch_mm, .energy_mm2 = 0.5 * stretch_mm * stretch_mm}},
                   .stiffness_N_per_mm = 0.5},
                  {.position = {{0, 0, z_mm}}})
                 .N;
      acted.add(stage.acted());
    }
    CHECK((acted.has(Limit::Damping) || acted.has(Limit::EnergyCut)) == dishonest);
    if (dishonest)
      CHECK(given_J < 2.0 / 3.0 * unlimited_J);
    else
      CHECK(given_J == doctest::Approx(unlimited_J));
  }
}

TEST_CASE("damping: with 0.5 N allowed, push and braking together are never more") {
  SafetyStage stage = ready();
  bool braked = false;
  double peak_N = 0;
  for (int k = 0; k < 4000; ++k) {
    // To and fro at up to 0.5 m/s through a wall that pushes three times as hard on the way out.
    const double phase = k * 0.01, z_mm = 50 * std::sin(phase), out = std::cos(phase) > 0 ? 0.3 : 0.1;
    stage.beginTick({.position = {{0, 0, z_mm}}}, {});
    const double stretch_mm = std::max(0.0, -z_mm);
    const ForceN force =
        stage
            .output({.force_N = {0, 0, out * stretch_mm},
                     .stored = {.springs = {.stretch_mm = stretch_mm, .energy_mm2 = 0.5 * stretch_mm * stretch_mm}},
                     .stiffness_N_per_mm = 0.2,
                     .max_N = 0.5})
            .force;
    braked = braked || stage.acted().has(Limit::Damping);
    peak_N = std::max(peak_N, glm::length(force.N));
  }
  CHECK(braked);
  CHECK(peak_N <= 0.5 + 1e-9);
}

TEST_CASE("each limit has one bit, a name and a sentence") {
  LimitFlags seen;
  for (const LimitWords& words : limitWords()) {
    CHECK_FALSE(seen.has(words.limit));
    seen.add(words.limit);
    CHECK_FALSE(words.name.empty());
    CHECK(words.sentence.back() == '.');
  }
  CHECK(limitWords().size() == 15);
}
