// Speed of the trackers: contact (0.02 A per tick, 0.6 A below the surface), free space, moving spheres, and the time
// until a scene can be touched. Run: build/release/tracker_benchmark [--benchmark_filter=…]. `moltact replay --time`
// measures tail times.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>

#include "engine/bench/hip_paths.h"
#include "engine/bench/methods/bench_methods.h"
#include "engine/bench/scenes.h"
#include "engine/haptics/body/rigid_body.h"
#include "engine/haptics/exact/exact_tracker.h"
#include "engine/haptics/methods.h"
#include "engine/haptics/sphere_motion.h"
#include "engine/servo/servo_step.h"

namespace {

using namespace moltact;

constexpr std::size_t kTicks = 200'000;

std::shared_ptr<const SphereGrid> scene(std::size_t count) {
  static std::map<std::size_t, std::shared_ptr<const SphereGrid>> made;
  auto& one = made[count];
  if (!one) one = std::make_shared<SphereGrid>(bench::proteinLike(count, 1));
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

// The path's next position; after the last it restarts, which is not timed.
template <class Begin>
void next(benchmark::State& state, std::size_t& k, std::size_t places, const Begin& begin) {
  if (++k < places) return;
  state.PauseTiming();
  begin();
  k = 0;
  state.ResumeTiming();
}

void ticks(benchmark::State& state, const Method* method, bool contact) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const std::vector<Vec3>& hips = path(count, contact);
  const auto tracker = method->make(scene(count), kWaterProbe_A);
  tracker->step({Vec3(1e4)});
  std::size_t k = 0, touching = 0;
  for (auto _ : state) {
    touching += tracker->step({hips[k]}).touching();
    next(state, k, hips.size(), [&] {  // by way of the outside, as at first
      tracker->reset();
      tracker->step({Vec3(1e4)});
    });
  }
  state.counters["touching"] = double(touching) / double(state.iterations());
  state.counters["atoms_modelled"] = double(tracker->memoryUsage().atoms_modelled);
}

// A whole tick of the servo loop in contact: tracker, spring and safety stage, for a device that gives force.
void servoTicks(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const std::vector<Vec3>& hips = path(count, true);
  const auto tracker = methods().front().make(scene(count), kWaterProbe_A);
  DeviceInfo info{shownForceFigures()};
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
    touching +=
        step->tick(settings, tracker.get(), {.position = settings.workspace.toDevice({hips[k]})}).contact.touching();
    next(state, k, hips.size(), begin);
  }
  state.counters["touching"] = double(touching) / double(state.iterations());
}

// A rigid body of as many atoms, 1.5 A apart in a rod as a drug's are, dragged over 3000 spheres and turned meanwhile.
void body(benchmark::State& state) {
  std::vector<Sphere> rod;
  std::vector<std::uint32_t> all;
  scenes::Random random(11);
  for (int k = 0; k < int(state.range(0)); ++k) {
    rod.push_back({Vec3(0.35 * k, 0, 0) + 1.2 * random.direction(), 1.7});
    all.push_back(std::uint32_t(k));
  }
  const auto held = heldBody(rod, all);
  static std::map<std::int64_t, std::vector<Vec3>> made;
  std::vector<Vec3>& hips = made[state.range(0)];
  if (hips.empty()) hips = bench::slidingPath(scene(3'000), 0.5 * held->reach_A, 0.6, kTicks, 2);
  RigidBody felt(held, [](double radius_A) { return methods().front().make(scene(3'000), radius_A); });
  std::size_t k = 0, touching = 0;
  double springs = 0.0;
  const auto begin = [&] {
    felt.reset();
    felt.respond({{Vec3(1e4)}});
  };
  begin();
  for (auto _ : state) {
    const Quat turned = glm::angleAxis(2e-4 * double(k), Vec3(0, 0, 1));
    const Response answer = felt.respond({{hips[k]}, turned});
    touching += answer.contact.touching();
    springs += answer.stiffness_factor;
    next(state, k, hips.size(), begin);
  }
  state.counters["touching"] = double(touching) / double(state.iterations());
  state.counters["springs"] = springs / double(state.iterations());
}

void ready(benchmark::State& state) {
  const std::vector<Sphere> spheres = bench::proteinLike(static_cast<std::size_t>(state.range(0)), 1);
  for (auto _ : state) {
    auto prepared = std::make_shared<SphereGrid>(spheres);
    const auto tracker = methods().front().make(prepared, kWaterProbe_A);
    benchmark::DoNotOptimize(tracker->step({Vec3(1e4)}));
  }
}

// Atoms that swing by 0.5 A in directions and at paces of their own, in frames of 33 ticks.
std::vector<std::unique_ptr<const SphereMotion>> swinging(std::size_t count, int frames) {
  const std::vector<Sphere> rest = bench::proteinLike(count, 1);
  scenes::Random random(7);
  std::vector<Vec3> way(count);
  std::vector<double> phase(count), pace(count);
  for (std::size_t i = 0; i < count; ++i) {
    way[i] = 0.5 * random.direction();
    phase[i] = random.uniform(0.0, 6.28);
    pace[i] = random.uniform(0.05, 0.3);
  }
  const auto at = [&](int frame) {
    std::vector<Sphere> out = rest;
    for (std::size_t i = 0; i < count; ++i) out[i].centre_A += way[i] * std::sin(phase[i] + pace[i] * frame);
    return out;
  };
  std::vector<std::unique_ptr<const SphereMotion>> out;
  out.push_back(*SphereMotion::make(at(0), at(1), 33));
  for (int k = 1; k < frames; ++k) out.push_back(*SphereMotion::after(*out.back(), at(k + 1), 33));
  return out;
}

// Contact while every sphere moves in every tick; beside `contact` of the same method in the same run.
void moving(benchmark::State& state, const Method* method) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const auto frames = swinging(count, 600);
  const std::vector<Vec3>& hips = path(count, true);
  const auto tracker = method->make(scene(count), kWaterProbe_A);
  std::size_t k = 0, frame = 0, touching = 0;
  int tick = 33;
  const auto begin = [&] {
    tracker->reset();
    tracker->setMotion(nullptr);
    tracker->step({Vec3(1e4)});
    k = frame = 0;
    tick = 33;
  };
  begin();
  for (auto _ : state) {
    if (tick == 33) tracker->setMotion(frames[frame++].get()), tick = 0;
    tracker->advanceTo(++tick / 33.0);
    touching += tracker->step({hips[k++]}).touching();
    if (k == hips.size() || (tick == 33 && frame == frames.size())) {
      state.PauseTiming();
      begin();
      state.ResumeTiming();
    }
  }
  state.counters["touching"] = double(touching) / double(state.iterations());
}

// What a new frame costs beside the loop.
void makeFrame(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const auto frames = swinging(count, 2);
  const std::vector<Sphere> to = frames[1]->at(1.0);
  for (auto _ : state) benchmark::DoNotOptimize(*SphereMotion::after(*frames[0], to, 33));
}

// The exact tracker where most lies in the way: each tick's time, in us.
void worst(benchmark::State& state, const std::vector<Sphere>& spheres, double probe_A) {
  const auto crowd = std::make_shared<SphereGrid>(spheres);
  const Vec3 middle = 0.5 * (crowd->low_A() + crowd->high_A());
  const double half = 0.5 * glm::distance(crowd->low_A(), crowd->high_A()) + probe_A;
  scenes::Random random(5);
  std::vector<Vec3> hips{middle + Vec3(half, 0, 0)};
  for (int k = 1; k < 20'000; ++k) {
    const Vec3 last = hips.back();
    hips.push_back(k % 500 == 0 ? middle + random.direction() * half * random.uniform(0, 1)
                                : last + 0.02 * random.direction() +
                                      0.01 * (middle + 0.6 * half * glm::normalize(last - middle) - last));
  }
  std::vector<double> ticks_us;
  std::uint64_t cut = 0;
  for (auto _ : state) {
    const auto tracker = std::make_unique<ExactTracker>(crowd, probe_A);
    for (const Vec3& hip : hips) {
      const auto begin = std::chrono::steady_clock::now();
      benchmark::DoNotOptimize(tracker->step({hip}));
      ticks_us.push_back(std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count());
    }
    cut = tracker->cutShort();
  }
  std::sort(ticks_us.begin(), ticks_us.end());
  const auto at = [&](double share) { return ticks_us[std::size_t(share * double(ticks_us.size() - 1))]; };
  state.counters["p50_us"] = at(0.5);
  state.counters["p99_us"] = at(0.99);
  state.counters["p999_us"] = at(0.999);
  state.counters["cut"] = double(cut);
}

std::vector<Sphere> within(double radius_A, int count) {
  scenes::Random random(1);
  std::vector<Sphere> spheres;
  for (int k = 0; k < count; ++k)
    spheres.push_back({random.direction() * radius_A * std::cbrt(random.uniform(0, 1)), random.uniform(1.4, 1.6)});
  return spheres;
}

}  // namespace

int main(int argc, char** argv) {
  // One resolution of each method; the others differ in accuracy, which `moltact bench` charts.
  for (const Method& method : bench::benchMethods()) {
    constexpr std::string_view kShown[] = {"exact", "paper", "mesh960", "mesh960-tree", "grid04", "penalty"};
    if (std::find(std::begin(kShown), std::end(kShown), method.name) == std::end(kShown)) continue;
    for (const bool contact : {true, false}) {
      const std::string name = std::string(method.name) + (contact ? "/contact" : "/free");
      auto* one = benchmark::RegisterBenchmark(name.c_str(),
                                               [&method, contact](benchmark::State& s) { ticks(s, &method, contact); });
      for (const int count : {50, 150, 3'000, 14'000, 1'000'000}) one->Arg(count);
    }
  }
  for (const char* name : {"exact", "penalty", "mesh960"}) {
    const Method* method = findMethod(name);
    benchmark::RegisterBenchmark((std::string(name) + "/moving").c_str(), [method](benchmark::State& s) {
      moving(s, method);
    })->Arg(14'000);
  }
  benchmark::RegisterBenchmark("frame", makeFrame)->Arg(14'000)->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("worst/100000 balls in 0.1 A", [](benchmark::State& s) {
    worst(s, within(0.1, 100'000), kWaterProbe_A);
  })->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("worst/14000 balls, probe 20 A", [](benchmark::State& s) {
    worst(s, bench::proteinLike(14'000, 1), 20.0);
  })->Unit(benchmark::kMillisecond);
  benchmark::RegisterBenchmark("servo/contact", servoTicks)->Arg(3'000);
  benchmark::RegisterBenchmark("body/contact", body)->Arg(1)->Arg(35)->Arg(200);
  benchmark::RegisterBenchmark("ready", ready)->Arg(3'000)->Arg(14'000)->Arg(1'000'000)->Unit(benchmark::kMillisecond);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
}
