// Speed of the trackers: contact (0.02 A a tick, 0.6 A under the surface), free space, and the time until a scene can
// be touched. Run: build/release/tracker_benchmark [--benchmark_filter=…]. Tail times come from `moltact replay --time`.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>

#include "engine/haptics/methods.h"
#include "engine/bench/hip_paths.h"
#include "engine/servo/servo_step.h"

namespace {

using namespace moltact;

constexpr std::size_t kTicks = 200'000;

std::shared_ptr<const BallScene> scene(std::size_t count) {
  static std::map<std::size_t, std::shared_ptr<const BallScene>> made;
  auto& one = made[count];
  if (!one) one = std::make_shared<BallScene>(bench::proteinLike(count, 1));
  return one;
}

const std::vector<Vec3>& path(std::size_t count, bool contact) {
  static std::map<std::pair<std::size_t, bool>, std::vector<Vec3>> made;
  auto& one = made[{count, contact}];
  if (one.empty())
    one = contact ? bench::slidingPath(scene(count), kWaterProbe_A, 0.6, kTicks, 2)
                  : bench::freePath(scene(count), kWaterProbe_A, kTicks, 3);
  return one;
}

void ticks(benchmark::State& state, const Method* method, bool contact) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const std::vector<Vec3>& hips = path(count, contact);
  const auto tracker = method->make(scene(count), kWaterProbe_A);
  tracker->step({Vec3(1e4)});
  std::size_t k = 0, touching = 0;
  for (auto _ : state) {
    touching += tracker->step({hips[k]}).touching();
    if (++k == hips.size()) {  // back to the start by way of the outside, as at first
      state.PauseTiming();
      tracker->reset();
      tracker->step({Vec3(1e4)});
      k = 0;
      state.ResumeTiming();
    }
  }
  state.counters["touching"] = double(touching) / double(state.iterations());
  state.counters["atoms_modelled"] = double(tracker->footprint().atoms_modelled);
}

// A whole tick of the servo loop in contact: tracker, spring and safety stage, for a device that gives force.
void servoTicks(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const std::vector<Vec3>& hips = path(count, true);
  const auto tracker = methods().front().make(scene(count), kWaterProbe_A);
  DeviceInfo info;
  info.gives_force = true;
  const ServoSettings settings;
  std::optional<ServoStep> step;
  const auto begin = [&] {  // from the outside to the path's start, where the loop takes the contact up
    tracker->reset();
    tracker->step({Vec3(1e4)});
    tracker->step({hips.front()});
    step.emplace(info);
  };
  begin();
  std::size_t k = 0, touching = 0;
  for (auto _ : state) {
    touching += step->tick(settings, tracker.get(), {.position = settings.workspace.toDevice({hips[k]})}).contact.touching();
    if (++k == hips.size()) {
      state.PauseTiming();
      begin();
      k = 0;
      state.ResumeTiming();
    }
  }
  state.counters["touching"] = double(touching) / double(state.iterations());
}

void ready(benchmark::State& state) {
  const std::vector<Ball> balls = bench::proteinLike(static_cast<std::size_t>(state.range(0)), 1);
  for (auto _ : state) {
    auto prepared = std::make_shared<BallScene>(balls);
    const auto tracker = methods().front().make(prepared, kWaterProbe_A);
    benchmark::DoNotOptimize(tracker->step({Vec3(1e4)}));
  }
}

}  // namespace

int main(int argc, char** argv) {
  // One resolution of each method; the others differ in accuracy, which `moltact bench` charts.
  for (const Method& method : methods()) {
    constexpr std::string_view kShown[] = {"exact", "paper", "mesh960", "mesh960-tree", "grid04", "penalty"};
    if (std::find(std::begin(kShown), std::end(kShown), method.name) == std::end(kShown)) continue;
    for (const bool contact : {true, false}) {
      const std::string name = std::string(method.name) + (contact ? "/contact" : "/free");
      auto* one = benchmark::RegisterBenchmark(name.c_str(), [&method, contact](benchmark::State& s) { ticks(s, &method, contact); });
      for (const int count : {50, 150, 3'000, 14'000, 1'000'000}) one->Arg(count);
    }
  }
  benchmark::RegisterBenchmark("servo/contact", servoTicks)->Arg(3'000);
  benchmark::RegisterBenchmark("ready", ready)->Arg(3'000)->Arg(14'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
}
