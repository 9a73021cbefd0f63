// What a frame of a moving molecule costs the window's thread beside drawing: the next motion for the hand, the atoms'
// places at the newest tick, and the picture's data for them. 14 000 and 100 000 atoms.
// Run: build/release/motion_benchmark [--benchmark_filter=…]
#include <benchmark/benchmark.h>

#include <memory>
#include <utility>
#include <vector>

#include "engine/bench/hip_paths.h"
#include "engine/haptics/sphere_grid.h"
#include "engine/haptics/sphere_motion.h"
#include "engine/render/molecule_model.h"

namespace {

using namespace moltact;

constexpr int kFrame_ticks = 33;

std::shared_ptr<const Molecule> moleculeOf(std::size_t atoms) {
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
  return std::make_shared<const Molecule>(std::move(molecule));
}

std::vector<Sphere> shifted(std::span<const Sphere> spheres) {
  std::vector<Sphere> out(spheres.begin(), spheres.end());
  for (std::size_t i = 0; i < out.size(); ++i) out[i].centre_A.x += 0.05 * double(i % 3);
  return out;
}

void nextMotion(benchmark::State& state) {
  const auto molecule = moleculeOf(std::size_t(state.range(0)));
  const std::vector<Sphere> to = shifted(molecule->spheres);
  const auto first = SphereMotion::make(molecule->spheres, to, kFrame_ticks, {});
  for (auto _ : state) benchmark::DoNotOptimize(SphereMotion::after(**first, molecule->spheres, kFrame_ticks));
}
BENCHMARK(nextMotion)->Arg(14'000)->Arg(100'000)->Unit(benchmark::kMillisecond);

void placesNow(benchmark::State& state) {
  const auto molecule = moleculeOf(std::size_t(state.range(0)));
  const auto motion = SphereMotion::make(molecule->spheres, shifted(molecule->spheres), kFrame_ticks, {});
  for (auto _ : state) benchmark::DoNotOptimize(molecule->movedTo((*motion)->at(0.5)));
}
BENCHMARK(placesNow)->Arg(14'000)->Arg(100'000)->Unit(benchmark::kMillisecond);

void gridOfMotion(benchmark::State& state) {
  const auto molecule = moleculeOf(std::size_t(state.range(0)));
  const auto motion = SphereMotion::make(molecule->spheres, shifted(molecule->spheres), kFrame_ticks, {});
  const SharedArray<Sphere> places = (*motion)->at(0.5);
  for (auto _ : state) benchmark::DoNotOptimize(SphereGrid::within((*motion)->sweptSpheres(), places));
}
BENCHMARK(gridOfMotion)->Arg(14'000)->Arg(100'000)->Unit(benchmark::kMillisecond);

// For comparison: what gridOfMotion replaces.
void sphereGrid(benchmark::State& state) {
  const auto molecule = moleculeOf(std::size_t(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(SphereGrid(molecule->spheres));
}
BENCHMARK(sphereGrid)->Arg(14'000)->Arg(100'000)->Unit(benchmark::kMillisecond);

void model(benchmark::State& state) {
  const auto molecule = moleculeOf(std::size_t(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(MoleculeModel(molecule, 1'000'000));
}
BENCHMARK(model)->Arg(14'000)->Arg(100'000)->Unit(benchmark::kMillisecond);

void modelMoved(benchmark::State& state) {
  const auto one = moleculeOf(std::size_t(state.range(0)));
  const auto two = std::make_shared<const Molecule>(one->movedTo(shifted(one->spheres)));
  MoleculeModel made(one, 1'000'000);
  bool there = false;
  for (auto _ : state) benchmark::DoNotOptimize(made.moveTo((there = !there) ? two : one));
}
BENCHMARK(modelMoved)->Arg(14'000)->Arg(100'000)->Unit(benchmark::kMillisecond);

// All that one frame of a trajectory costs the window's thread beside drawing.
void wholeFrame(benchmark::State& state) {
  const auto molecule = moleculeOf(std::size_t(state.range(0)));
  const std::vector<Sphere> ends[] = {shifted(molecule->spheres), molecule->spheres.copy()};
  std::unique_ptr<const SphereMotion> motion = *SphereMotion::make(molecule->spheres, ends[0], kFrame_ticks, {});
  MoleculeModel picture(molecule, 1'000'000);
  int frame = 0;
  for (auto _ : state) {
    motion = *SphereMotion::after(*motion, ends[++frame % 2], kFrame_ticks);
    const SharedArray<Sphere> places = motion->at(0.5);
    benchmark::DoNotOptimize(SphereGrid::within(motion->sweptSpheres(), places));
    benchmark::DoNotOptimize(picture.moveTo(std::make_shared<const Molecule>(molecule->movedTo(places))));
  }
}
BENCHMARK(wholeFrame)->Arg(14'000)->Arg(100'000)->Unit(benchmark::kMillisecond);

// Computed beside the window's thread.
void light(benchmark::State& state) {
  MoleculeModel made(moleculeOf(std::size_t(state.range(0))), 1'000'000);
  for (auto _ : state) benchmark::DoNotOptimize(lightAmong(made.spheres, {}));
}
BENCHMARK(light)->Arg(14'000)->Arg(100'000)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
