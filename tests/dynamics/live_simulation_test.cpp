// The logic of a simulation beside a window, with an engine whose motion has a closed form: each atom moves along x at a
// constant speed, so that positions and times are known to the step.
#include "engine/dynamics/live_simulation.h"

#include <doctest/doctest.h>

#include <cmath>

#include "engine/dynamics/simulation_slices.h"

using namespace moltact;

namespace {

// 0.004 ps a step; every atom moves by 0.001 A a step. Becomes unstable after `steps_to_fault` steps.
class Straight final : public MdEngine {
 public:
  std::string name() const override { return "Straight"; }
  static constexpr double kStep_ps = 0.004, kStep_A = 0.001;
  std::size_t atomCount() const override { return 2; }
  std::span<const double> masses_u() const override { return masses_; }
  double step_ps() const override { return kStep_ps; }
  std::string_view platform() const override { return "straight"; }
  double measured_steps_per_s() const override { return 0.0; }
  std::span<const PlatformRate> measured() const override { return {}; }
  std::string push(std::span<const AtomPush> pushes) override {
    pushed = pushes.size();
    return {};
  }
  std::string setTemperature(double kelvin) override {
    temperature_K = kelvin;
    return {};
  }
  std::string advance(int steps) override {
    done += steps;
    return throws_at >= 0 && done >= throws_at ? "Particle coordinate is nan" : "";
  }
  // Lowers the energy by 1 kcal/mol in each of the first `uphill` iterations.
  std::string relax(int iterations) override {
    ++relaxed;
    iterated += iterations;
    most_at_once = std::max(most_at_once, iterations);
    energy_kcal_mol -= std::min(iterations, uphill);
    uphill -= std::min(iterations, uphill);
    return {};
  }
  std::string restart() override {
    ++restarted;
    done = 0;
    return restart_fails ? "no" : "";
  }
  std::span<const Vec3> positions_A() override {
    at_ = {Vec3(kStep_A * done, 0, 0), Vec3(kStep_A * done, 5, 0)};
    if (far_at >= 0 && done >= far_at) at_[1].y = std::nan("");
    return at_;
  }
  MdEnergies energies() override { return {energy_kcal_mol, 2.0, hot ? 1e5 : temperature_K}; }

  int done = 0, throws_at = -1, far_at = -1, relaxed = 0, iterated = 0, most_at_once = 0, uphill = 0, restarted = 0;
  double energy_kcal_mol = -1.0;
  std::size_t pushed = 0;
  double temperature_K = 0.0;
  bool hot = false, restart_fails = false;

 private:
  std::vector<double> masses_{12.0, 12.0};
  std::vector<Vec3> at_;
};

struct Bench {
  Straight* engine = new Straight;
  SimulationRun run{std::unique_ptr<MdEngine>(engine)};
};

}  // namespace

TEST_CASE("at 1 ps a second, 4 s in slices of 7 ms make 1000 steps of 4 fs; at most 3 a slice, each slice makes 3") {
  Bench b;
  SimulationCommand wanted;
  for (int k = 0; k < 571; ++k) b.run.advance(wanted, 0.007, 1000);
  CHECK(b.engine->done == 999);  // 571 slices are 3.997 s
  CHECK(b.run.advance(wanted, 0.003, 1000).time_ps == doctest::Approx(4.0));
  CHECK(b.engine->done == 1000);
  wanted.ps_per_s = 20.0;
  for (int k = 0; k < 10; ++k) {
    const SimulationFrame& frame = b.run.advance(wanted, 0.01, 3);
    // 3 steps of 4 fs in 10 ms: what it achieves, and not what was asked for.
    CHECK(frame.ps_per_s == doctest::Approx(1.2));
  }
  CHECK(b.engine->done == 1030);
}

TEST_CASE("the positions of a frame are the mean of its steps: eight moments of 80 steps end at 80 and average 45") {
  Bench b;
  SimulationCommand wanted;
  wanted.ps_per_s = 16.0;
  const SimulationFrame& frame = b.run.advance(wanted, 0.02, 1000);
  CHECK(b.engine->done == 80);
  CHECK(frame.positions_A[0].x == doctest::Approx(45 * Straight::kStep_A));
  CHECK(frame.positions_A[1].y == doctest::Approx(5.0));
}

TEST_CASE(
    "while it stands still nothing moves; a single step is 0.02 ps, five steps, once, though the command is repeated") {
  Bench b;
  SimulationCommand wanted;
  wanted.running = false;
  CHECK(b.run.advance(wanted, 1.0, 1000).time_ps == 0.0);
  wanted.singles = 1;
  for (int k = 0; k < 3; ++k) b.run.advance(wanted, 1.0, 1000);
  CHECK(b.engine->done == 5);
  // The time that it stood still is not made up for.
  wanted.running = true;
  b.run.advance(wanted, 0.004, 1000);
  CHECK(b.engine->done == 6);
}

TEST_CASE("relaxations and restarts are carried out once each, the temperature and the pushes are passed on") {
  Bench b;
  SimulationCommand wanted;
  wanted.temperature_K = 350.0;
  wanted.pushes.resize(3);
  wanted.restarts = 1;
  wanted.relaxations = 1;
  for (int k = 0; k < 5; ++k) b.run.advance(wanted, 0.1, 1000);
  const SimulationFrame frame = b.run.advance(wanted, 0.1, 1000);
  CHECK(b.engine->restarted == 1);
  CHECK(b.engine->relaxed == 2);  // the second slice lowers the energy no more
  CHECK(b.engine->temperature_K == 350.0);
  CHECK(b.engine->pushed == 3);
  CHECK(frame.starts == 2);
  CHECK(frame.energies.potential_kcal_mol == -1.0);
}

TEST_CASE(
    "a relaxation goes on in slices of 50 iterations, one a call, without a step and without a new frame; it ends at "
    "the "
    "slice that lowers the energy no more, or after 500 iterations, and a restart ends it at once") {
  for (const int uphill : {0, 70, 1'000'000}) {
    Bench b;
    CAPTURE(uphill);
    b.engine->uphill = uphill;
    SimulationCommand wanted;
    b.run.advance(wanted, 0.1, 1000);
    const int before = b.engine->done;
    wanted.relaxations = 1;
    int calls = 0;
    std::uint64_t serial = 0;
    do {
      const SimulationFrame& frame = b.run.advance(wanted, 0.02, 1000);
      ++calls;
      if (b.run.relaxing()) {
        CHECK(frame.starts == 0);
        CHECK((serial == 0 || frame.serial == serial));
        CHECK(b.engine->done == before);
        serial = frame.serial;
      }
    } while (b.run.relaxing() && calls < 1000);
    // The first slice has nothing to compare with. 70 iterations end within the second slice, and the third lowers nothing.
    CHECK(calls == (uphill == 0 ? 2 : uphill == 70 ? 3 : 10));
    CHECK(b.engine->iterated == calls * SimulationRun::kRelaxSlice);
    CHECK(b.engine->iterated <= SimulationRun::kRelaxIterations);
    CHECK(b.engine->most_at_once == SimulationRun::kRelaxSlice);
    CHECK(b.run.advance(wanted, 0.02, 1000).starts == 1);
    CHECK(b.engine->done > before);
  }
  Bench b;
  b.engine->uphill = 1'000'000;
  SimulationCommand wanted;
  wanted.relaxations = 1;
  b.run.advance(wanted, 0.02, 1000);
  REQUIRE(b.run.relaxing());
  wanted.restarts = 1;
  CHECK(b.run.advance(wanted, 0.02, 1000).starts == 1);
  CHECK_FALSE(b.run.relaxing());
  CHECK(b.engine->iterated == SimulationRun::kRelaxSlice);
}

TEST_CASE(
    "an engine that fails, an atom that is nowhere and a temperature of 100 000 K each end the run: it says so, is "
    "back "
    "at "
    "its start, pushes nothing and stands still until the next restart") {
  for (const int how : {0, 1, 2}) {
    Bench b;
    CAPTURE(how);
    SimulationCommand wanted;
    wanted.pushes.resize(1);
    b.run.advance(wanted, 0.1, 1000);
    if (how == 0) b.engine->throws_at = 40;
    if (how == 1) b.engine->far_at = 40;
    if (how == 2) b.engine->hot = true;
    SimulationFrame frame = b.run.advance(wanted, 0.1, 1000);
    b.engine->throws_at = b.engine->far_at = -1;
    b.engine->hot = false;
    CHECK(frame.blow_ups == 1);
    CHECK_FALSE(frame.dead);
    CHECK(b.engine->restarted == 1);
    CHECK(b.engine->pushed == 0);
    CHECK((frame.fault == "Particle coordinate is nan") == (how == 0));
    for (const Vec3& v : frame.positions_A) CHECK(finite(v));
    frame = b.run.advance(wanted, 1.0, 1000);
    CHECK(b.engine->done == 0);
    CHECK(b.engine->pushed == 0);
    CHECK(frame.blow_ups == 1);
    CHECK(frame.positions_A[0].x == 0.0);
    wanted.restarts = 1;
    frame = b.run.advance(wanted, 0.1, 1000);
    CHECK(b.engine->done == 25);
    CHECK(frame.fault.empty());
  }
}

TEST_CASE("slices: 10 s and -1 s of the window's time count as 0.1 s and none; facts are the engine's") {
  SimulationSlices slices(std::make_unique<Straight>());
  SimulationCommand wanted;
  wanted.ps_per_s = 0.4;  // 10 steps in 0.1 s, fewer than any first slice may make
  CHECK(slices.advance(wanted, 10.0).time_ps == doctest::Approx(0.04));
  CHECK(slices.advance(wanted, -1.0).time_ps == doctest::Approx(0.04));
  const EngineFacts facts = factsOf(slices.engine());
  CHECK(facts.name == "Straight");
  CHECK(facts.platform == "straight");
  CHECK(facts.step_ps == Straight::kStep_ps);
}

TEST_CASE("an engine that cannot even start again is dead, and is not called any more") {
  Bench b;
  SimulationCommand wanted;
  b.engine->throws_at = 1;
  b.engine->restart_fails = true;
  CHECK(b.run.advance(wanted, 0.1, 1000).dead);
  const int done = b.engine->done;
  wanted.restarts = 1;
  CHECK(b.run.advance(wanted, 0.1, 1000).dead);
  CHECK(b.engine->done == done);
}

TEST_CASE(
    "a push has the given force where the atom is, falls linearly as the atom gives way, and never pulls: 2 kcal/mol/A "
    "by a spring of 4 are gone after 0.5 A") {
  const Vec3 at(1, 2, 3), force(0, -2, 0);
  const AtomPush push = pushOf(7, at, force, 4.0);
  CHECK(push.atom == 7);
  CHECK(push.force_kcal_mol_A(at) * push.direction.y == doctest::Approx(-2.0));
  CHECK(push.force_kcal_mol_A(at + Vec3(0, -0.25, 0)) == doctest::Approx(1.0));
  CHECK(push.force_kcal_mol_A(at + Vec3(9, -0.25, 9)) == doctest::Approx(1.0));
  CHECK(push.force_kcal_mol_A(at + Vec3(0, -0.51, 0)) == 0.0);
  CHECK(push.force_kcal_mol_A(at + Vec3(0, -5.0, 0)) == 0.0);
}

TEST_CASE("the step is 4 fs with heavy hydrogens on rigid bonds, 2 fs with light ones, 0.5 fs without rigid bonds") {
  CHECK(stepFor_ps(4.0, true) == 0.004);
  CHECK(stepFor_ps(3.03, true) == 0.004);
  CHECK(stepFor_ps(1.008, true) == 0.002);
  CHECK(stepFor_ps(1.008, false) == 0.0005);
}
