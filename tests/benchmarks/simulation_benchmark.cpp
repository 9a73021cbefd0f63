// The delay of a simulation on its own thread: the time from a command of the window to the first positions that it has
// changed. The command is a restart, whose execution the frame reports. Then the latencies of a window of 60 frames per
// second, which reads the hand, sends the command and draws the newest positions once per frame: from a step of the hand,
// at any time between two frames, to the start of the frame that draws it; and to the felt atoms, which follow by 63 % with
// the window's filter and a piece of motion (engine/dynamics/felt_atoms.h). Last the time for which a window that
// closes during a relaxation waits.
// Run: build/release/simulation_benchmark [--chart FILE.svg] MOLECULE...   (prepared by `moltact simulate prepare`)
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "engine/bench/chart_svg.h"
#include "engine/core/random.h"
#include "engine/dynamics/felt_atoms.h"
#include "engine/dynamics/simulation_engines.h"
#include "engine/dynamics/simulation_thread.h"
#include "engine/molecule/catalogue.h"
#include "engine/molecule/reader.h"
#include "engine/platform/write_file.h"

namespace {

using namespace moltact;
using Clock = std::chrono::steady_clock;

constexpr int kCommands = 100, kClosings = 10;
constexpr auto kFrame = std::chrono::microseconds(16'667);
constexpr double kMotion_ms = 1e3 * kFeltStep_s;

struct Latency {
  std::size_t atoms = 0;
  double picture_ms = 0.0, picture_p99_ms = 0.0, force_ms = 0.0, force_p99_ms = 0.0;
};
std::vector<Latency> measured;

double milliseconds(Clock::duration d) { return std::chrono::duration<double, std::milli>(d).count(); }

int fail(const Problem& problem) {
  std::fprintf(stderr, "%s\n", problem.text().c_str());
  return 1;
}

double quantile(std::vector<double>& of, double share) {
  std::sort(of.begin(), of.end());
  return of[std::size_t(share * double(of.size() - 1))];
}

// A window's frames, on the clock.
void measureWindow(SimulationThread& simulation, SimulationCommand& command, const char* name, std::size_t atoms) {
  std::uint64_t random = 5;
  std::vector<double> picture_ms, frames, force_ms;
  Clock::time_point frame = Clock::now();
  for (int k = 0; k < kCommands; ++k) {
    for (int rest = 0; rest < 3; ++rest) std::this_thread::sleep_until(frame += kFrame);
    const std::uint32_t before = simulation.newest().starts;
    // The hand steps before the next frame begins, which sends it.
    const double early_ms = milliseconds(kFrame) * nextFraction(random);
    std::this_thread::sleep_until(frame += kFrame);
    ++command.restarts;
    simulation.command(command);
    int passed = 0;
    do {
      std::this_thread::sleep_until(frame += kFrame);
      ++passed;
    } while (simulation.newest().starts == before && passed < 600);
    const double drawn_ms = early_ms + passed * milliseconds(kFrame);
    frames.push_back(passed + 1);
    picture_ms.push_back(drawn_ms);
    // Each frame moves the felt atoms by a share of what is left, in a motion that begins then.
    double felt = 0.0, more_ms = kMotion_ms;
    for (; felt < 1.0 - std::exp(-1.0); more_ms += milliseconds(kFrame))
      felt += (1.0 - felt) * feltShare(1e-3 * milliseconds(kFrame));
    force_ms.push_back(drawn_ms + more_ms - milliseconds(kFrame));
  }
  const Latency l{atoms, quantile(picture_ms, 0.5), quantile(picture_ms, 0.99), quantile(force_ms, 0.5),
                  quantile(force_ms, 0.99)};
  std::printf(
      "%-24s %6zu atoms   hand to picture median %5.1f ms, p99 %5.1f ms: frame %.0f after the step, p99 %.0f; hand to "
      "felt "
      "atoms (63 %%) median %5.1f ms, p99 %5.1f ms\n",
      name, atoms, l.picture_ms, l.picture_p99_ms, quantile(frames, 0.5), quantile(frames, 0.99), l.force_ms,
      l.force_p99_ms);
  measured.push_back(l);
}

int drawChart(const char* file) {
  using namespace bench;
  ChartSeries picture{"hand to picture, median", markAt(0), true, false, true, {}},
      picture99{"hand to picture, 99th percentile", markAt(1), true, true, true, {}},
      force{"hand to force, median", markAt(2), true, false, true, {}},
      force99{"hand to force, 99th percentile", markAt(3), true, true, true, {}};
  std::sort(measured.begin(), measured.end(), [](const Latency& a, const Latency& b) { return a.atoms < b.atoms; });
  for (const Latency& l : measured) {
    const double atoms = double(l.atoms);
    picture.points.push_back({atoms, l.picture_ms, {}});
    picture99.points.push_back({atoms, l.picture_p99_ms, {}});
    force.points.push_back({atoms, l.force_ms, {}});
    force99.points.push_back({atoms, l.force_p99_ms, {}});
  }
  const std::string svg =
      chartSvg("Latency of a simulated molecule", {{"", "atoms", "milliseconds", {picture, picture99, force, force99}}},
               "A window of 60 frames per second; the force follows by 63 %.");
  const auto problem = writeWhole(file, svg);
  return problem ? fail(*problem) : 0;
}

int measure(const char* name) {
  const auto key = findMoleculeKey({name}, MoleculeFolders::ofThisComputer());
  if (!key) return fail(key.problem());
  const auto molecule = readMolecule(*key);
  if (!molecule) return fail(molecule.problem());
  MdStart start;
  auto engine = simulationOf(systemBeside(key->file), *molecule, start);
  if (!engine) return fail(engine.problem());
  const std::string platform((*engine)->platform());
  start.platform = platform;
  auto simulation = std::make_unique<SimulationThread>(*std::move(engine));
  SimulationCommand command;
  simulation->command(command);
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  std::vector<double> exact_ms;
  for (int k = 0; k < kCommands; ++k) {
    // The phase between the window's frames and the simulation's slices varies from command to command.
    std::this_thread::sleep_for(std::chrono::microseconds(20'000 + 137 * k));
    const std::uint32_t before = simulation->newest().starts;
    ++command.restarts;
    const Clock::time_point began = Clock::now();
    simulation->command(command);
    while (simulation->newest().starts == before) std::this_thread::sleep_for(std::chrono::microseconds(50));
    const Clock::duration took = Clock::now() - began;
    exact_ms.push_back(milliseconds(took));
  }
  const double ps_per_s = simulation->newest().ps_per_s;
  measureWindow(*simulation, command, name, molecule->atoms.size());
  // A run first, so that the relaxation has something to do.
  std::vector<double> closing_ms;
  for (int k = 0; k < kClosings; ++k) {
    if (!simulation) {
      auto again = simulationOf(systemBeside(key->file), *molecule, start);
      if (!again) return fail(again.problem());
      simulation = std::make_unique<SimulationThread>(*std::move(again));
      command = {};
      simulation->command(command);
      std::this_thread::sleep_for(std::chrono::milliseconds(500));
    }
    ++command.relaxations;
    simulation->command(command);
    std::this_thread::sleep_for(std::chrono::milliseconds(7 + 3 * k));
    const Clock::time_point began = Clock::now();
    simulation.reset();
    closing_ms.push_back(milliseconds(Clock::now() - began));
  }
  std::printf(
      "%-24s %6zu atoms %-10s %7.2f ps/s   delay median %6.1f ms, p99 %6.1f ms; closed during a "
      "relaxation in %.1f ms, at most %.1f ms\n",
      name, molecule->atoms.size(), platform.c_str(), ps_per_s, quantile(exact_ms, 0.5), quantile(exact_ms, 0.99),
      quantile(closing_ms, 0.5), quantile(closing_ms, 1.0));
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  int failed = 0, first = 1;
  const char* chart = nullptr;
  if (count > 2 && std::strcmp(arguments[1], "--chart") == 0) chart = arguments[2], first = 3;
  for (int k = first; k < count; ++k) failed |= measure(arguments[k]);
  if (count == first) failed = measure("alanine-dipeptide");
  if (chart) failed |= drawChart(chart);
  return failed;
}
