// Times a tick's sum of forces between atoms in a browser, on the tasks of `moltact bench energies`. A page's clock has
// steps of up to 0.1 ms, so whole paths are timed, and a tick's time is their mean. `python3 tests/web/speed.py forces`
// opens this page and writes what it prints to docs/page-ticks.csv.
#include <algorithm>
#include <chrono>
#include <cstdio>

#include "engine/bench/energies/energy_task.h"
#include "engine/haptics/field/pair_sum.h"
#include "engine/molecule/reader.h"

namespace {

using namespace moltact;
using SteadyClock = std::chrono::steady_clock;

constexpr int kTicks = 500, kRuns = 7;

double seconds(SteadyClock::time_point from) {
  return std::chrono::duration<double>(SteadyClock::now() - from).count();
}

// As distanceLoop_ns(), but of many loops at once.
double loop_us() {
  constexpr int kLoops = 20'000;
  std::vector<Sphere> spheres;
  for (int k = 0; k < 1000; ++k) spheres.push_back({Vec3(0.05 * k, 0.02 * k, -0.03 * k), 1.7});
  double best = 1e9;
  volatile double sink = 0.0;
  for (int run = 0; run < kRuns; ++run) {
    const auto from = SteadyClock::now();
    for (int loop = 0; loop < kLoops; ++loop) {
      const Vec3 p(0.001 * loop, 0.0, 0.0);
      double least = 1e9;
      for (const Sphere& s : spheres) least = std::min(least, glm::distance(p, s.centre_A) - s.radius_A);
      sink = sink + least;
    }
    best = std::min(best, 1e6 * seconds(from) / kLoops);
  }
  return best;
}

}  // namespace

int main() {
  const double loop = loop_us();
  std::printf("held,scene,mean_us,loop_us\n");
  for (const std::string_view name : bench::kEnergyTasks) {
    const auto task = bench::energyTask(name, [](const std::string& id) { return readMolecule("/" + id + ".pdb"); });
    if (!task) {
      std::printf("%s\n", task.problem().text().c_str());
      return 1;
    }
    const std::vector<PoseA> path = bench::energyPath(*task, kTicks);
    PairSum sum(task->scene, task->atoms, task->held, {});
    volatile double felt = 0.0;
    double best_s = 1e9;
    for (int run = 0; run < kRuns; ++run) {
      const auto from = SteadyClock::now();
      for (const PoseA& pose : path) felt = felt + sum.at(pose).energy.felt_kcal_mol;
      best_s = std::min(best_s, seconds(from));
    }
    std::printf("%zu,%zu,%.3f,%.3f\n", task->held.size(), task->atoms.size(), 1e6 * best_s / kTicks, loop);
  }
  std::printf("end\n");
  return 0;
}
