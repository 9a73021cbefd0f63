#include "engine/haptics/methods.h"

#include <algorithm>
#include <array>

#include "engine/haptics/exact/exact_tracker.h"
#include "engine/haptics/grid/grid_tracker.h"
#include "engine/haptics/mesh/mesh_tracker.h"
#include "engine/haptics/mesh/sphere_mesh.h"
#include "engine/haptics/paper/paper_tracker.h"
#include "engine/haptics/penalty/penalty_tracker.h"
#include "engine/haptics/sas_mesh/sas_mesh_tracker.h"
#include "engine/language/catalogue.h"

namespace moltact {
namespace {

template <class T>
std::unique_ptr<Tracker> make(std::shared_ptr<const BallScene> scene, double probe_A) {
  return std::make_unique<T>(std::move(scene), probe_A);
}

template <int triangles, bool smooth = false, bool coherent = true>
std::unique_ptr<Tracker> makeMesh(std::shared_ptr<const BallScene> scene, double probe_A) {
  return std::make_unique<MeshTracker>(std::move(scene), probe_A, MeshTracker::Options{triangles, smooth, coherent});
}

template <int tenths_A, bool prepared = false>
std::unique_ptr<Tracker> makeGrid(std::shared_ptr<const BallScene> scene, double probe_A) {
  return std::make_unique<GridTracker>(std::move(scene), probe_A, 0.1 * tenths_A, prepared);
}

template <int hundredths_A>
std::unique_ptr<Tracker> makeSasMesh(std::shared_ptr<const BallScene> scene, double probe_A) {
  return std::make_unique<SasMeshTracker>(std::move(scene), probe_A, 0.01 * hundredths_A);
}

constexpr std::size_t kMostPrepared = 20'000;  // balls whose whole surface is modelled in seconds and some 100 MB

constexpr MethodFamily kExact{N_("Exact"), N_("Follows the spheres themselves, without error.")},
    kPaper{N_("Paper"), N_("The steps of Stocks and Laycock, 2008, as they were published.")},
    kMesh{N_("Mesh"), N_("Triangles stand in for each sphere. The fewer there are, the more you feel their edges.")},
    kGrid{N_("Grid"), N_("Distances are stored on a grid. The wider apart, the rounder its creases become.")},
    kPenalty{N_("Penalty"), N_("Each atom pushes for itself, and nothing remembers from which side you came.")},
    kSurfaceMesh{N_("Surface mesh"), N_("One mesh of the whole surface, made beforehand.")};

// A method that cannot follow spheres that move.
constexpr Method still(Method method) {
  method.follows_motion = false;
  return method;
}

constexpr std::array kMethods{
    Method{"exact", N_("the sphere tracker without error: the god-object on the union of balls"), &make<ExactTracker>,
           kExact},
    still(Method{"paper", N_("Algorithm 1 of Stocks and Laycock (2008) as published, its faults included"),
                 &make<PaperTracker>, kPaper}),
    Method{"mesh80", N_("a god-object on 80 triangles a ball"), &makeMesh<80>, kMesh, "80", "", 80},
    Method{"mesh320", N_("a god-object on 320 triangles a ball"), &makeMesh<320>, kMesh, "320", "", 320},
    Method{"mesh960", N_("a god-object on 960 triangles a ball, as many as in the paper"), &makeMesh<960>, kMesh, "960",
           N_("Flat"), 960},
    Method{"mesh1280", N_("a god-object on 1280 triangles a ball"), &makeMesh<1280>, kMesh, "1280", "", 1280},
    Method{"mesh5120", N_("a god-object on 5120 triangles a ball"), &makeMesh<5120>, kMesh, "5120", "", 5120},
    Method{"mesh960-smooth", N_("the same on 960 triangles with interpolated normals: force shading"),
           &makeMesh<960, true>, kMesh, "960", N_("Smooth"), 960},
    Method{"mesh960-tree", N_("the same on 960 triangles, the trees asked anew in every tick"),
           &makeMesh<960, false, false>, kMesh, "960", N_("No memory"), 960},
    still(Method{"grid02", N_("a signed-distance grid, smoothly interpolated, 0.2 A apart"), &makeGrid<2>, kGrid,
                 N_("0.2 Å")}),
    still(Method{"grid04", N_("a signed-distance grid, smoothly interpolated, 0.4 A apart"), &makeGrid<4>, kGrid,
                 N_("0.4 Å")}),
    still(Method{"grid08", N_("a signed-distance grid, smoothly interpolated, 0.8 A apart"), &makeGrid<8>, kGrid,
                 N_("0.8 Å")}),
    Method{"penalty", N_("the sum of each ball's push, without a proxy"), &make<PenaltyTracker>, kPenalty},
    // For the bench only:
    still(Method{"grid02-ready", N_("the grid 0.2 A apart, made beforehand wherever the surface is"),
                 &makeGrid<2, true>, kGrid, N_("0.2 Å"), N_("Ready"), 0, kMostPrepared}),
    still(Method{"grid04-ready", N_("the grid 0.4 A apart, made beforehand wherever the surface is"),
                 &makeGrid<4, true>, kGrid, N_("0.4 Å"), N_("Ready"), 0, kMostPrepared}),
    still(Method{"sasmesh05",
                 N_("a god-object on one manifold mesh of the surface, made beforehand on a grid 0.5 A apart"),
                 &makeSasMesh<50>, kSurfaceMesh, N_("0.5 Å"), "", 0, kMostPrepared, true}),
    still(Method{"sasmesh025",
                 N_("a god-object on one manifold mesh of the surface, made beforehand on a grid 0.25 A apart"),
                 &makeSasMesh<25>, kSurfaceMesh, N_("0.25 Å"), "", 0, kMostPrepared, true}),
};

constexpr std::size_t kOffered =
    std::size_t(std::find_if(kMethods.begin(), kMethods.end(), [](const Method& m) { return m.most_balls > 0; }) -
                kMethods.begin());

}  // namespace

std::span<const Method> methods() { return benchMethods().first(kOffered); }

std::span<const Method> benchMethods() { return kMethods; }

const Method* findMethod(std::string_view name) {
  for (const Method& m : methods())
    if (m.name == name) return &m;
  return nullptr;
}

const Method* findBenchMethod(std::string_view name) {
  for (const Method& m : benchMethods())
    if (m.name == name) return &m;
  return nullptr;
}

std::vector<std::string_view> methodNames() {
  std::vector<std::string_view> names;
  for (const Method& m : methods()) names.push_back(m.name);
  return names;
}

std::shared_ptr<const SphereMesh> feltFacets(std::string_view method) {
  const Method* m = findMethod(method);
  return m && m->triangles > 0 ? SphereMesh::ofTriangles(m->triangles) : nullptr;
}

std::string methodTitle(std::string_view name) {
  const Method* m = findBenchMethod(name);
  if (!m) return std::string(name);
  std::string title(tr(m->family.name));
  if (!m->grade.empty()) title.append(" ").append(tr(m->grade));
  if (!m->variant.empty() && m->variant != "Flat") title.append(", ").append(tr(m->variant));
  return title;
}

}  // namespace moltact
