// Tick times of the exact rigid body: bodies of 1 to 5000 atoms, pressed into a scene, dragged and twisted. Each time is
// the minimum over three runs of the same tick, divided by the time of a plain loop of 1000 sphere distances in the same
// process, so that figures of different machines can be compared. `moltact bench bodies` compares methods.
// Run: build/release/body_benchmark [name of a scene, see body_tasks.h]
#include <algorithm>
#include <cstdio>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

#include "engine/bench/bodies/body_tasks.h"
#include "engine/bench/bodies/body_trade_off.h"
#include "engine/haptics/body/exact_body.h"
#include "engine/molecule/reader.h"

namespace {

using namespace moltact;

constexpr int kTicks = 4000, kRuns = 3;

void timeTicks(const bench::BodyTask& task) {
  const std::vector<PoseA> path = bench::pathOf(task, kTicks);
  ExactBody felt(task.scene, task.body);
  felt.respond({{task.home}});
  std::size_t touching = 0, resting = 0;
  long steps = 0;
  for (const PoseA& hand : path) {
    const Response r = felt.respond(hand);
    touching += r.contact.touching();
    resting += r.at_rest;
    steps += felt.steps();
  }
  const double loop = bench::distanceLoop_ns(), n = double(path.size());
  const std::vector<double> ns = bench::bodyTickTimes_ns(
      task, [&] { return std::make_unique<ExactBody>(task.scene, task.body); }, path, kRuns);
  const auto at_us = [&](double share) { return ns[std::min(ns.size() - 1, std::size_t(share * n))] / 1e3; };
  const double mean_us = std::accumulate(ns.begin(), ns.end(), 0.0) / n / 1e3;
  std::printf("| %s | %.1f %% | %.2f %% | %.2f | %.1f | %.1f | %.0f | %.0f | %.0f | %.2f | %.0f |\n", task.name.c_str(),
              100.0 * double(touching) / n, 100.0 * double(resting) / n, double(steps) / n, mean_us, at_us(0.5),
              at_us(0.99), at_us(0.999), ns.back() / 1e3, 1e3 * mean_us / loop, 1e3 * at_us(0.999) / loop);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const auto open = [](const std::string& id) {
    return readMolecule(std::string(MOLTACT_SOURCE_DIR "/molecules/") + id + ".pdb");
  };
  std::printf(
      "| body | contact | at rest | steps | mean us | p50 | p99 | p99.9 | max | mean / loop | p99.9 / loop |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const std::string_view name : bench::kBodyTasks) {
    if (argc > 1 && name != argv[1]) continue;
    const auto task = bench::bodyTask(name, open);
    if (!task) {
      std::fprintf(stderr, "%s\n", task.problem().text().c_str());
      return 2;
    }
    timeTicks(*task);
  }
  std::printf("loop of 1000 sphere distances: %.2f us\n", bench::distanceLoop_ns() / 1e3);
}
