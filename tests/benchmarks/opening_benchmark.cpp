// The time to open each lesson of the program: from the request to the first picture of 1280 x 800 pixels with its
// molecule, read, coloured and lit, in the program's own window off-screen. Another molecule is loaded before. `Time`
// is wall time, `CPU` that of all threads of the program. Run on an idle machine: build/release/opening_benchmark
// [--benchmark_filter=…]
#include <benchmark/benchmark.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/ui/shell/scripted_user.h"
#include "engine/lesson/lesson_files.h"

namespace {

using namespace moltact;

ScriptedUser* user() {
  static auto made = ScriptedUser::create({});
  return made ? made->get() : nullptr;
}

void opening(benchmark::State& state, const std::filesystem::path& lesson) {
  ScriptedUser* const u = user();
  if (!u) return state.SkipWithError("no graphics");
  for (auto _ : state) {
    state.PauseTiming();
    u->app().open("argon");
    u->frames(2);
    benchmark::DoNotOptimize(u->picture());
    state.ResumeTiming();
    u->app().open(lesson.string());
    u->frames(1);
    benchmark::DoNotOptimize(u->picture());
  }
  state.counters["atoms"] = double(u->app().scene.stage().molecule->atoms.size());
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::filesystem::path> lessons;
  for (const auto& entry : std::filesystem::directory_iterator(MOLTACT_SOURCE_DIR "/lessons"))
    if (moltact::looksLikeLesson(entry.path()) && entry.path().stem().extension().empty())
      lessons.push_back(entry.path());
  std::sort(lessons.begin(), lessons.end());
  for (const std::filesystem::path& lesson : lessons)
    benchmark::RegisterBenchmark(("opening/" + lesson.stem().string()).c_str(),
                                 [lesson](benchmark::State& state) { opening(state, lesson); })
        ->Unit(benchmark::kMillisecond)
        ->MeasureProcessCPUTime()
        ->UseRealTime();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
