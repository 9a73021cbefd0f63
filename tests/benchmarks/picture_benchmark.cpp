// Pictures per second of 1280 x 800 pixels, off-screen, with EGL's graphics driver (software rendering without a
// graphics card). Measured while the view rotates and everything is redrawn, at full size and as the window does
// (window), and while the probe moves over a resting view. CPU time is that of all threads of the program. The counter
// `frames_s` is the window's possible frame rate. Run: build/release/picture_benchmark [--benchmark_filter=…].
#include <benchmark/benchmark.h>

#include <chrono>
#include <map>
#include <memory>

#include "engine/bench/hip_paths.h"
#include "engine/platform/offscreen_gl.h"
#include "engine/render/adaptive_quality.h"
#include "engine/render/renderer.h"

namespace {

using namespace moltact;

constexpr int kWidth_px = 1280, kHeight_px = 800;

Renderer* renderer() {
  static auto gl = OffscreenGl::create();
  if (!gl) return nullptr;
  static auto made = Renderer::create();
  return made ? made->get() : nullptr;
}

ViewScene sceneOf(std::size_t atoms) {
  static std::map<std::size_t, std::shared_ptr<const Molecule>> made;
  auto& one = made[atoms];
  if (!one) {
    std::vector<PlacedAtom> placed;
    for (const Sphere& b : bench::proteinLike(atoms, 1)) {
      PlacedAtom a;
      a.position.A = b.centre_A;
      a.radius_A = b.radius_A;
      a.atomic_number = std::uint8_t(6 + placed.size() % 3);
      placed.push_back(a);
    }
    Molecule molecule;
    molecule.setAtoms(placed);
    one = std::make_shared<const Molecule>(std::move(molecule));
  }
  ViewScene scene;
  scene.molecule = one;
  scene.camera.fit(*one, double(kWidth_px) / kHeight_px);
  scene.hip = PointA{scene.camera.target.A + scene.camera.back() * 0.3 * scene.camera.distance_A};
  return scene;
}

void frames(benchmark::State& state, bool turning) {
  Renderer* const r = renderer();
  if (!r) return state.SkipWithError("no graphics");
  ViewScene scene = sceneOf(std::size_t(state.range(0)));
  const RenderOptions options{.samples = int(state.range(1))};
  if (r->draw(scene, kWidth_px, kHeight_px, options)) return state.SkipWithError("the driver refuses the picture");
  r->finish();
  for (auto _ : state) {
    if (turning)
      scene.camera.orbit(0.03, 0.0);
    else
      scene.hip->A.x += 0.01;
    r->draw(scene, kWidth_px, kHeight_px, options);
    r->finish();
  }
  state.counters["frames_s"] = benchmark::Counter(double(state.iterations()), benchmark::Counter::kIsRate);
  state.counters["atoms_drawn"] = double(r->count().atoms_drawn);
}

// As the window draws a view of this size while it turns: as finely as the machine allows.
void window(benchmark::State& state) {
  Renderer* const r = renderer();
  if (!r) return state.SkipWithError("no graphics");
  ViewScene scene = sceneOf(std::size_t(state.range(0)));
  AdaptiveQuality fineness;
  double scale = 0.0;
  const auto frame = [&] {
    scene.camera.orbit(0.03, 0.0);
    const AdaptiveQuality::Choice choice = fineness.choose(true);
    const auto begun = std::chrono::steady_clock::now();
    if (r->draw(scene, int(kWidth_px * choice.scale), int(kHeight_px * choice.scale), choice.options)) return false;
    r->finish();
    fineness.took(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count());
    scale += choice.scale;
    return true;
  };
  constexpr int kUntilKnown = 10;  // frames in which it finds out how fast the machine is
  for (int k = 0; k < kUntilKnown; ++k)
    if (!frame()) return state.SkipWithError("the driver refuses the picture");
  scale = 0.0;
  for (auto _ : state) frame();
  state.counters["frames_s"] = benchmark::Counter(double(state.iterations()), benchmark::Counter::kIsRate);
  state.counters["scale"] = scale / double(state.iterations());
}

void turning(benchmark::State& state) { frames(state, true); }
void touching(benchmark::State& state) { frames(state, false); }

BENCHMARK(turning)
    ->ArgNames({"atoms", "samples"})
    ->ArgsProduct({{4600, 14000, 677040}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK(window)
    ->ArgNames({"atoms"})
    ->ArgsProduct({{4600, 14000, 677040}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK(touching)
    ->ArgNames({"atoms", "samples"})
    ->ArgsProduct({{4600, 14000, 677040}, {1, 2}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
