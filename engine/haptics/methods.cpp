#include "engine/haptics/methods.h"

#include <algorithm>
#include <array>

#include "engine/haptics/exact/exact_tracker.h"
#include "engine/haptics/grid/grid_tracker.h"
#include "engine/haptics/mesh/mesh_tracker.h"
#include "engine/haptics/mesh/sphere_mesh.h"
#include "engine/haptics/paper/paper_tracker.h"
#include "engine/haptics/penalty/penalty_tracker.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"

namespace moltact {
namespace {

template <class T>
std::unique_ptr<Tracker> make(std::shared_ptr<const SphereGrid> scene, double probe_A) {
  return std::make_unique<T>(std::move(scene), probe_A);
}

template <int triangles, bool smooth = false>
std::unique_ptr<Tracker> makeMesh(std::shared_ptr<const SphereGrid> scene, double probe_A) {
  return std::make_unique<MeshTracker>(std::move(scene), probe_A, MeshTracker::Options{triangles, smooth});
}

template <int tenths_A>
std::unique_ptr<Tracker> makeGrid(std::shared_ptr<const SphereGrid> scene, double probe_A) {
  return std::make_unique<GridTracker>(std::move(scene), probe_A, 0.1 * tenths_A);
}

constexpr MethodFamily kExact{N_("Exact"), N_("Follows the spheres themselves, without error.")},
    kPaper{N_("Paper"), N_("The steps of Stocks and Laycock, 2008, as they were published.")},
    kMesh{N_("Mesh"), N_("Triangles stand in for each sphere. The fewer there are, the more you feel their edges.")},
    kGrid{N_("Grid"), N_("Distances are stored on a grid. The wider apart, the rounder its creases become.")},
    kPenalty{N_("Penalty"), N_("Each atom pushes for itself, and nothing remembers from which side you came.")};

constexpr std::array kTable{
    Method{.name = "exact",
           .sentence = N_("the sphere tracker without error: the god-object on the union of spheres"),
           .make = &make<ExactTracker>,
           .family = kExact,
           .follows_motion = true,
           .reference = true},
    Method{.name = "paper",
           .sentence = N_("Algorithm 1 of Stocks and Laycock (2008) as published, its faults included"),
           .make = &make<PaperTracker>,
           .family = kPaper},
    Method{.name = "mesh80",
           .sentence = N_("a god-object on 80 triangles per sphere"),
           .make = &makeMesh<80>,
           .family = kMesh,
           .grade = "80",
           .triangles = 80,
           .follows_motion = true},
    Method{.name = "mesh320",
           .sentence = N_("a god-object on 320 triangles per sphere"),
           .make = &makeMesh<320>,
           .family = kMesh,
           .grade = "320",
           .triangles = 320,
           .follows_motion = true},
    Method{.name = "mesh960",
           .sentence = N_("a god-object on 960 triangles per sphere, as many as in the paper"),
           .make = &makeMesh<960>,
           .family = kMesh,
           .grade = "960",
           .variant = N_("Flat"),
           .plain_variant = true,
           .triangles = 960,
           .follows_motion = true,
           .former_name = "mesh960-tree"},
    Method{.name = "mesh1280",
           .sentence = N_("a god-object on 1280 triangles per sphere"),
           .make = &makeMesh<1280>,
           .family = kMesh,
           .grade = "1280",
           .triangles = 1280,
           .follows_motion = true},
    Method{.name = "mesh5120",
           .sentence = N_("a god-object on 5120 triangles per sphere"),
           .make = &makeMesh<5120>,
           .family = kMesh,
           .grade = "5120",
           .triangles = 5120,
           .follows_motion = true},
    Method{.name = "mesh960-smooth",
           .sentence = N_("the same on 960 triangles with interpolated normals: force shading"),
           .make = &makeMesh<960, true>,
           .family = kMesh,
           .grade = "960",
           .variant = N_("Smooth"),
           .triangles = 960,
           .shaded = true,
           .follows_motion = true},
    Method{.name = "grid02",
           .sentence = N_("a signed-distance grid of 0.2 A, smoothly interpolated"),
           .make = &makeGrid<2>,
           .family = kGrid,
           .grid_spacing_A = 0.2},
    Method{.name = "grid04",
           .sentence = N_("a signed-distance grid of 0.4 A, smoothly interpolated"),
           .make = &makeGrid<4>,
           .family = kGrid,
           .grid_spacing_A = 0.4},
    Method{.name = "grid08",
           .sentence = N_("a signed-distance grid of 0.8 A, smoothly interpolated"),
           .make = &makeGrid<8>,
           .family = kGrid,
           .grid_spacing_A = 0.8},
    Method{.name = "penalty",
           .sentence = N_("the sum of the push of each sphere, without a proxy"),
           .make = &make<PenaltyTracker>,
           .family = kPenalty,
           .summed = true,
           .follows_motion = true},
};

static_assert(std::count_if(kTable.begin(), kTable.end(), [](const Method& m) { return m.reference; }) == 1);

}  // namespace

std::span<const Method> methods() { return kTable; }

const Method* findMethod(std::string_view name) {
  for (const Method& m : methods())
    if (m.name == name || (!m.former_name.empty() && m.former_name == name)) return &m;
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

const Method& referenceMethod() {
  return *std::find_if(kTable.begin(), kTable.end(), [](const Method& m) { return m.reference; });
}

std::string_view motionSentence(const Method& method) {
  return method.follows_motion ? std::string_view()
                               : N_("It stays with the atoms as they stood: it cannot follow them while they move.");
}

std::string gradeText(const Method& method) {
  if (method.grid_spacing_A > 0.0) return quantityText(method.grid_spacing_A, Dimension::Length, plain());
  return method.grade.empty() ? std::string() : std::string(tr(method.grade));
}

std::string methodTitle(std::string_view name) {
  const Method* m = findMethod(name);
  if (!m) return std::string(name);
  std::string title(tr(m->family.name));
  if (const std::string grade = gradeText(*m); !grade.empty()) title.append(" ").append(grade);
  if (!m->variant.empty() && !m->plain_variant) title.append(", ").append(tr(m->variant));
  return title;
}

}  // namespace moltact
