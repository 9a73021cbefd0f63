// The impulses on the atoms between two reads: their sum is the integral of the force, whenever they are read.
#include "engine/servo/atom_impulses.h"

#include <doctest/doctest.h>

#include <atomic>
#include <cmath>
#include <map>
#include <memory>
#include <random>
#include <thread>
#include <vector>

#include "engine/device/device_model.h"
#include "engine/servo/servo_loop.h"
#include "tests/haptics/fields.h"

using namespace moltact;

namespace {

constexpr double kWell_N_per_A = 0.02;

// A hand that circles above three harmonic wells.
struct CirclingHand final : Device {
  DeviceInfo is{phantomOmniFigures()};
  int tick = 0;
  CirclingHand() { is.gives_force = true, is.delay_s = 0.0; }
  const DeviceInfo& info() const noexcept override { return is; }
  DevicePose read(double) noexcept override {
    const double angle = 0.004 * tick++;
    return {.position = {{30.0 + 8.0 * std::cos(angle), 8.0 * std::sin(angle), 12.0}}};
  }
  void write(ForceN) noexcept override {}
};

const std::vector<test::Harmonic::Atom> kWells{{7, {0, 0, 0}}, {700'000, {1, 2, -1}}, {19, {-2, 0, 1}}};

std::unique_ptr<Interaction> wells() {
  return std::make_unique<test::Harmonic>(std::make_unique<test::OpenSpace>(), test::HarmonicPair{kWell_N_per_A},
                                          kWells);
}

// Adds what a read returned.
struct Total {
  std::map<std::int32_t, Vec3> atoms;
  Vec3 sum_N_s{0.0}, dropped_N_s{0.0}, earlier_N_s{0.0};
  std::uint64_t ticks = 0;
  std::size_t dropped = 0;
  void take(const AtomImpulses& read) {
    for (const AtomImpulse& one : read.atoms()) atoms.try_emplace(one.atom, 0.0).first->second += one.impulse_N_s;
    sum_N_s += read.sum_N_s;
    dropped_N_s += read.dropped_N_s;
    earlier_N_s += read.earlier_N_s;
    ticks += read.ticks;
    dropped += read.dropped;
  }
  Vec3 ofAtoms() const {
    Vec3 out(0.0);
    for (const auto& [atom, impulse] : atoms) out += impulse;
    return out;
  }
};

}  // namespace

TEST_CASE(
    "over 6000 ticks the impulses that are read at 60 Hz and, from five seeds, at irregular times of 0 to 400 ticks "
    "are "
    "the integral of the force to 1e-12, per atom that of its own well; glow and impulses need not both be wanted") {
  for (const unsigned seed : {0u, 1u, 2u, 3u, 4u, 5u}) {
    CAPTURE(seed);  // 0: at 60 Hz
    std::mt19937 random(seed);
    CirclingHand hand;
    ServoLoop loop(hand);
    ServoSettings settings;
    settings.workspace.A_per_mm = 0.25;
    loop.setSettings(settings);
    loop.begin(0);
    loop.setInteraction(wells(), 3);
    loop.wantImpulses(true);
    loop.wantReactions(seed % 2 == 1);
    Total total;
    Vec3 integral_N_s(0.0);
    std::map<std::int32_t, Vec3> by_atom;
    std::int64_t until = 0;
    int reads = 0;
    for (std::int64_t tick = 1; tick <= 6000; ++tick) {
      loop.tick(tick * ServoLoop::kPeriod_ns, std::nullopt, nullptr);
      loop.drain([&](const ServoSample& s) {
        integral_N_s -= s.wanted().force_N * kTick_s;
        for (const auto& well : kWells)
          by_atom.try_emplace(well.atom, 0.0).first->second +=
              kWell_N_per_A * s.field_share * (s.hip.A - well.place_A) * kTick_s;
      });
      // 60 Hz: every 16 or 17 ticks.
      if (seed == 0 ? tick * 60 / 1000 == (tick - 1) * 60 / 1000 : tick < until) continue;
      until = tick + std::int64_t(random() % 401);
      total.take(loop.takeImpulses());
      ++reads;
    }
    total.take(loop.takeImpulses());
    total.take(loop.takeImpulses());
    CHECK(reads > 20);
    CHECK(total.ticks == 6000);
    CHECK(total.dropped == 0);
    REQUIRE(glm::length(integral_N_s) > 0.1);
    CHECK(glm::distance(total.sum_N_s, integral_N_s) <= 1e-12 * glm::length(integral_N_s));
    CHECK(glm::distance(total.ofAtoms(), integral_N_s) <= 1e-12 * glm::length(integral_N_s));
    REQUIRE(total.atoms.size() == 3);
    for (const auto& [atom, impulse] : by_atom)
      CHECK(glm::distance(total.atoms[atom], impulse) <= 1e-12 * glm::length(impulse));
  }
}

TEST_CASE("impulses continue over a change of the interaction in a scene; those of a scene before come as one sum") {
  CirclingHand hand;
  ServoLoop loop(hand);
  loop.setSettings({});
  loop.begin(0);
  loop.wantImpulses(true);
  std::int64_t tick = 0;
  Vec3 now_N_s(0.0);
  const auto pass = [&](int ticks) {
    now_N_s = Vec3(0.0);
    for (int k = 0; k < ticks; ++k) loop.tick(++tick * ServoLoop::kPeriod_ns, std::nullopt, nullptr);
    loop.drain([&](const ServoSample& s) { now_N_s -= s.wanted().force_N * kTick_s; });
    return now_N_s;
  };
  loop.setInteraction(wells(), 1);
  const Vec3 first = pass(50);
  loop.setInteraction(wells(), 1);
  const Vec3 second = pass(50);
  loop.setInteraction(wells(), 2);
  const Vec3 third = pass(7);
  const AtomImpulses& read = loop.takeImpulses();
  CHECK(read.scene == 2);
  CHECK(read.ticks == 7);
  CHECK(read.atoms().size() == 3);
  CHECK(glm::distance(read.earlier_N_s, first + second) <= 1e-12 * glm::length(first + second));
  CHECK(glm::distance(read.sum_N_s, third) <= 1e-12 * glm::length(third));
  // Without an interaction there is nothing to add.
  loop.setInteraction(nullptr, 2);
  pass(5);
  CHECK(loop.takeImpulses().ticks == 0);
}

TEST_CASE(
    "of 10 atoms in an exchange with room for 4, six are reported as a sum and a number; after the read there is room "
    "again, 3000 times") {
  ImpulseExchange exchange(4);
  CHECK(exchange.take().atoms().empty());
  for (int round = 0; round < 3000; ++round) {
    for (int k = 0; k < 2; ++k) {
      std::vector<AtomForce> forces;
      for (std::int32_t atom = 0; atom < 10; ++atom) forces.push_back({atom + round, Vec3(1 << atom, round, 1)});
      exchange.add(forces, 0.5, 0);
    }
    const AtomImpulses& read = exchange.take();
    REQUIRE(read.atoms().size() == 4);
    for (std::int32_t k = 0; k < 4; ++k) {
      REQUIRE(read.atoms()[std::size_t(k)].atom == k + round);
      REQUIRE(read.atoms()[std::size_t(k)].impulse_N_s == Vec3(1 << k, round, 1));
    }
    REQUIRE(read.dropped == 12);
    REQUIRE(read.dropped_N_s == Vec3(1008, 6 * round, 6));
    REQUIRE(read.sum_N_s == Vec3(1023, 10 * round, 10));
  }
}

TEST_CASE(
    "200 000 ticks of one thread that another thread reads at irregular times: every sum is equal to the last bit, and "
    "every tick is counted once") {
  constexpr int kTicks = 200'000, kAtoms = 50;
  ImpulseExchange exchange(64);
  std::atomic<bool> done{false};
  std::vector<double> given(kAtoms);
  std::thread haptic([&] {
    std::mt19937 random(6);
    for (int k = 0; k < kTicks; ++k) {
      // Multiples of a power of two, whose sums are exact.
      AtomForce forces[3];
      for (AtomForce& f : forces) {
        f = {std::int32_t(random() % kAtoms), Vec3(double(random() % 16), 0.0, 0.0)};
        given[std::size_t(f.atom)] += f.force_N.x / 1024.0;
      }
      exchange.add(forces, 1.0 / 1024.0, 5);
    }
    done = true;
  });
  Total total;
  std::mt19937 random(7);
  while (!done) {
    total.take(exchange.take());
    for (unsigned k = random() % 4; k > 0; --k) std::this_thread::yield();
  }
  haptic.join();
  for (int k = 0; k < 2; ++k) total.take(exchange.take());
  CHECK(total.ticks == kTicks);
  CHECK(total.dropped == 0);
  CHECK(total.earlier_N_s == Vec3(0.0));
  REQUIRE(total.atoms.size() == kAtoms);
  for (std::int32_t atom = 0; atom < kAtoms; ++atom) CHECK(total.atoms[atom].x == given[std::size_t(atom)]);
}
