#include "engine/bench/methods/bench_methods.h"

#include <array>
#include <memory>
#include <vector>

#include "engine/bench/methods/sas_mesh_tracker.h"
#include "engine/bench/methods/scanned_tracker.h"
#include "engine/haptics/grid/grid_tracker.h"
#include "engine/haptics/mesh/mesh_tracker.h"

namespace moltact::bench {
namespace {

struct MeasuredMethod {
  Method method;
  MethodLimits limits = {};
};

std::unique_ptr<Tracker> makeTreeMesh(std::shared_ptr<const SphereGrid> scene, double probe_A) {
  return std::make_unique<MeshTracker>(std::move(scene), probe_A,
                                       MeshTracker::Options{.triangles = 960, .smooth = false, .coherent = false});
}

template <int tenths_A>
std::unique_ptr<Tracker> makeReadyGrid(std::shared_ptr<const SphereGrid> scene, double probe_A) {
  return std::make_unique<GridTracker>(std::move(scene), probe_A, 0.1 * tenths_A, true);
}

template <int hundredths_A>
std::unique_ptr<Tracker> makeSasMesh(std::shared_ptr<const SphereGrid> scene, double probe_A) {
  return std::make_unique<SasMeshTracker>(std::move(scene), probe_A, 0.01 * hundredths_A);
}

template <int tenths_A>
std::unique_ptr<Tracker> makeScanned(std::shared_ptr<const SphereGrid> scene, double probe_A) {
  return std::make_unique<ScannedTracker>(std::move(scene), probe_A, 0.1 * tenths_A);
}

constexpr std::size_t kMaxPrepared = 20'000;  // scenes up to this size are prepared in seconds, in about 100 MB

constexpr MethodFamily kMesh{"Mesh", ""}, kGrid{"Grid", ""}, kSurfaceMesh{"Surface mesh", ""},
    kHeightField{"Height field", ""};

// The bench's reports are in English, so that these words are not translated.
constexpr std::array kTable{
    MeasuredMethod{{.name = "mesh960-tree",
                    .sentence = "a god-object on 960 triangles per sphere, with a full tree search in every tick",
                    .make = &makeTreeMesh,
                    .family = kMesh,
                    .grade = "960",
                    .triangles = 960,
                    .follows_motion = true}},
    MeasuredMethod{{.name = "grid02-ready",
                    .sentence = "the grid 0.2 A apart, made beforehand wherever the surface is",
                    .make = &makeReadyGrid<2>,
                    .family = kGrid,
                    .grid_spacing_A = 0.2},
                   {.max_spheres = kMaxPrepared}},
    MeasuredMethod{{.name = "grid04-ready",
                    .sentence = "the grid 0.4 A apart, made beforehand wherever the surface is",
                    .make = &makeReadyGrid<4>,
                    .family = kGrid,
                    .grid_spacing_A = 0.4},
                   {.max_spheres = kMaxPrepared}},
    MeasuredMethod{
        {.name = "sasmesh05",
         .sentence = "a god-object on one manifold mesh of the surface, made beforehand on a grid 0.5 A apart",
         .make = &makeSasMesh<50>,
         .family = kSurfaceMesh,
         .grid_spacing_A = 0.5},
        {.max_spheres = kMaxPrepared, .one_probe = true}},
    MeasuredMethod{
        {.name = "sasmesh025",
         .sentence = "a god-object on one manifold mesh of the surface, made beforehand on a grid 0.25 A apart",
         .make = &makeSasMesh<25>,
         .family = kSurfaceMesh,
         .grid_spacing_A = 0.25},
        {.max_spheres = kMaxPrepared, .one_probe = true}},
    MeasuredMethod{{.name = "height05",
                    .sentence = "a height field, scanned beforehand from +z by a tip of the probe's size, 0.5 A apart",
                    .make = &makeScanned<5>,
                    .family = kHeightField,
                    .grid_spacing_A = 0.5},
                   {.from_above = true}},
};

}  // namespace

std::span<const Method> benchMethods() {
  static const std::vector<Method> all = [] {
    std::vector<Method> out(methods().begin(), methods().end());
    for (const MeasuredMethod& row : kTable) out.push_back(row.method);
    return out;
  }();
  return all;
}

const Method* findBenchMethod(std::string_view name) {
  for (const Method& m : benchMethods())
    if (m.name == name) return &m;
  return nullptr;
}

MethodLimits limitsOf(const Method& method) {
  for (const MeasuredMethod& row : kTable)
    if (row.method.name == method.name) return row.limits;
  return {};
}

}  // namespace moltact::bench
