// The delay of a simulation on its own thread: the time from a command of the window to the first positions that it has
// changed, as a window of 60 frames per second sees it. The command is a restart, whose execution the frame reports.
// Run: build/release/simulation_benchmark MOLECULE...   (prepared by `moltact simulate prepare`)
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <thread>
#include <vector>

#include "engine/dynamics/simulation_engines.h"
#include "engine/dynamics/simulation_thread.h"
#include "engine/molecule/catalogue.h"
#include "engine/molecule/reader.h"

namespace {

using namespace moltact;
using Clock = std::chrono::steady_clock;

constexpr int kCommands = 100;
constexpr auto kFrame = std::chrono::microseconds(16'667);

double milliseconds(Clock::duration d) { return std::chrono::duration<double, std::milli>(d).count(); }

int fail(const Problem& problem) {
  std::fprintf(stderr, "%s\n", problem.text().c_str());
  return 1;
}

int measure(const char* name) {
  const auto key = findMoleculeKey({name}, MoleculeFolders::ofThisComputer());
  if (!key) return fail(key.problem());
  const auto molecule = readMolecule(*key);
  if (!molecule) return fail(molecule.problem());
  auto engine = simulationOf(systemBeside(key->file), *molecule, {});
  if (!engine) return fail(engine.problem());
  const std::string platform((*engine)->platform());
  SimulationThread simulation(*std::move(engine));
  SimulationCommand command;
  simulation.command(command);
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  std::vector<double> frames_ms, exact_ms;
  for (int k = 0; k < kCommands; ++k) {
    // The phase between the window's frames and the simulation's slices varies from command to command.
    std::this_thread::sleep_for(std::chrono::microseconds(20'000 + 137 * k));
    const std::uint32_t before = simulation.newest().starts;
    ++command.restarts;
    const Clock::time_point began = Clock::now();
    simulation.command(command);
    while (simulation.newest().starts == before) std::this_thread::sleep_for(std::chrono::microseconds(50));
    const Clock::duration took = Clock::now() - began;
    exact_ms.push_back(milliseconds(took));
    frames_ms.push_back(milliseconds(kFrame * (1 + took / kFrame)));
  }
  const double ps_per_s = simulation.newest().ps_per_s;
  const auto at = [](std::vector<double>& of, double share) {
    std::sort(of.begin(), of.end());
    return of[std::size_t(share * double(of.size() - 1))];
  };
  std::printf("%-24s %6zu atoms %-10s %7.2f ps/s   delay median %6.1f ms, p99 %6.1f ms; seen at 60 frames/s %5.1f ms\n",
              name, molecule->atoms.size(), platform.c_str(), ps_per_s, at(exact_ms, 0.5), at(exact_ms, 0.99),
              at(frames_ms, 0.5));
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  int failed = 0;
  for (int k = 1; k < count; ++k) failed |= measure(arguments[k]);
  if (count == 1) failed = measure("alanine-dipeptide");
  return failed;
}
