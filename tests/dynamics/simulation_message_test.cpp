// The messages between a page and its worker: what goes out comes in unchanged, and a row of another length is refused.
#include "engine/dynamics/simulation_message.h"

#include <doctest/doctest.h>

using namespace moltact;

TEST_CASE(
    "a command with a push and a grip, a frame of two atoms and a start survive their rows of numbers to the last "
    "bit") {
  TimedCommand sent;
  sent.elapsed_s = 0.017;
  sent.command = {
      .pushes = {{7, Vec3(1.0 / 3.0, -2, 3e-9), Vec3(0, 0.6, -0.8), 12.5}, {4999, Vec3(4, 5, 6), Vec3(0.0), 5}},
      .running = false,
      .ps_per_s = 0.1,
      .temperature_K = 310.15,
      .singles = 3,
      .relaxations = 4'000'000'000u,
      .restarts = 1};
  const auto got = commandOf(numbersOf(sent));
  REQUIRE(got);
  CHECK(got->elapsed_s == sent.elapsed_s);
  const SimulationCommand &a = got->command, &b = sent.command;
  CHECK(a.running == b.running);
  CHECK(a.ps_per_s == b.ps_per_s);
  CHECK(a.temperature_K == b.temperature_K);
  CHECK(a.singles == b.singles);
  CHECK(a.relaxations == b.relaxations);
  CHECK(a.restarts == b.restarts);
  REQUIRE(a.pushes.size() == 2);
  for (std::size_t k = 0; k < 2; ++k) {
    CHECK(a.pushes[k].atom == b.pushes[k].atom);
    CHECK(a.pushes[k].to_A == b.pushes[k].to_A);
    CHECK(a.pushes[k].direction == b.pushes[k].direction);
    CHECK(a.pushes[k].stiffness_kcal_mol_A2 == b.pushes[k].stiffness_kcal_mol_A2);
  }

  SimulationFrame frame;
  frame.serial = std::uint64_t(1) << 40;
  frame.positions_A = {Vec3(0.1, 0.2, 0.3), Vec3(-1e4, 0, 1e-300)};
  frame.time_ps = 1.25;
  frame.energies = {-17.123456789, 16.0, 299.5};
  frame.ps_per_s = 0.97;
  frame.starts = 2;
  frame.blow_ups = 1;
  frame.dead = true;
  const auto seen = frameOf(numbersOf(frame));
  REQUIRE(seen);
  CHECK(seen->serial == frame.serial);
  CHECK(seen->positions_A == frame.positions_A);
  CHECK(seen->time_ps == frame.time_ps);
  CHECK(seen->energies.potential_kcal_mol == frame.energies.potential_kcal_mol);
  CHECK(seen->energies.kinetic_kcal_mol == frame.energies.kinetic_kcal_mol);
  CHECK(seen->energies.temperature_K == frame.energies.temperature_K);
  CHECK(seen->ps_per_s == frame.ps_per_s);
  CHECK(seen->starts == frame.starts);
  CHECK(seen->blow_ups == frame.blow_ups);
  CHECK(seen->dead);

  MdStart start;
  start.positions_A = {Vec3(1, 2, 3)};
  start.temperature_K = 310.0;
  start.friction_per_ps = 0.5;
  start.hold_kcal_mol_A2 = 5.0;
  start.seed = 4'294'967'295u;
  start.step_ps = 0.002;
  const auto begun = startOf(numbersOf(start));
  REQUIRE(begun);
  CHECK(begun->positions_A == start.positions_A);
  CHECK(begun->temperature_K == start.temperature_K);
  CHECK(begun->friction_per_ps == start.friction_per_ps);
  CHECK(begun->hold_kcal_mol_A2 == start.hold_kcal_mol_A2);
  CHECK(begun->seed == start.seed);
  CHECK(begun->step_ps == start.step_ps);
}

TEST_CASE("rows that are a number too long or too short are nothing") {
  TimedCommand command;
  command.command.pushes.resize(2);
  SimulationFrame frame;
  frame.positions_A.resize(2);
  MdStart start;
  start.positions_A.resize(2);
  const auto refused = [](std::vector<double> row, auto&& read) {
    REQUIRE(read(row));
    row.pop_back();
    CHECK_FALSE(read(row));
    row.resize(row.size() + 2);
    CHECK_FALSE(read(row));
    row.resize(2);
    CHECK_FALSE(read(row));
    CHECK_FALSE(read({}));
  };
  refused(numbersOf(command), [](const std::vector<double>& row) { return commandOf(row).has_value(); });
  refused(numbersOf(frame), [](const std::vector<double>& row) { return frameOf(row).has_value(); });
  refused(numbersOf(start), [](const std::vector<double>& row) { return startOf(row).has_value(); });
}
