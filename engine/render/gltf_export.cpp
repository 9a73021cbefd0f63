#include "engine/render/gltf_export.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>

#include "engine/gltf/closed_surface.h"
#include "engine/language/catalogue.h"
#include "engine/molecule/elements.h"

namespace moltact {
namespace {

constexpr double kNm_per_A = 0.1;

std::string number(double value, const char* unit) {
  char text[64];
  std::snprintf(text, sizeof text, "%.6g %s", value, unit);
  return text;
}

// Materials by element, in the order in which elements come up.
class Elements {
 public:
  Elements(GltfScene& scene, ElementColours colours) : scene_(scene), colours_(colours) {}
  std::size_t operator[](std::uint8_t atomic_number) {
    const auto [it, made] = known_.try_emplace(atomic_number, scene_.materials.size());
    if (made)
      scene_.materials.push_back({std::string(element(atomic_number).name), elementColour(atomic_number, colours_)});
    return it->second;
  }

 private:
  GltfScene& scene_;
  ElementColours colours_;
  std::map<std::uint8_t, std::size_t> known_;
};

void addBalls(const Molecule& molecule, const ExportOptions& options, const Vec3& middle_A, GltfScene& scene) {
  const double unit = kNm_per_A * options.units_per_nm;
  Elements elements(scene, options.colours);
  std::map<std::size_t, std::size_t> mesh_of;  // by material
  const GltfMesh ball = ballMesh();
  std::map<std::uint32_t, std::size_t> group_of;  // a chain's node
  scene.nodes.push_back({.name = scene.title});
  for (std::size_t i = 0; i < molecule.atoms.size(); ++i) {
    const Atom& atom = molecule.atoms[i];
    const std::size_t material = elements[atom.atomic_number];
    const auto [mesh, new_mesh] = mesh_of.try_emplace(material, scene.meshes.size());
    if (new_mesh) {
      GltfMesh made = ball;
      made.name = scene.materials[material].name;
      made.parts[0].material = material;
      scene.meshes.push_back(std::move(made));
    }
    std::size_t parent = 0;
    if (atom.residue != kNoResidue) {
      const std::uint32_t chain = molecule.residues[atom.residue].chain;
      const auto [group, new_group] = group_of.try_emplace(chain, scene.nodes.size());
      if (new_group) scene.nodes.push_back({.name = "chain " + molecule.chains[chain].name.string(), .parent = 0});
      parent = group->second;
    }
    scene.nodes.push_back({.name = molecule.describe(i),
                           .mesh = mesh->second,
                           .parent = parent,
                           .place = glm::vec3((atom.position.A - middle_A) * unit),
                           .scale = float((atom.radius_A + options.probe_A) * unit)});
  }
}

void addSurface(const Molecule& molecule, const ExportOptions& options, const std::vector<Ball>& balls, double step_A,
                GltfScene& scene) {
  const ClosedSurface surface = closedSurface(balls, step_A);
  const auto unit = float(kNm_per_A * options.units_per_nm);
  GltfMesh mesh{.name = "surface", .places = surface.places, .normals = surface.normals, .parts = {}};
  for (glm::vec3& p : mesh.places) p *= unit;
  Elements elements(scene, options.colours);
  for (std::size_t t = 0; t < surface.owners.size(); ++t) {
    const std::size_t material = elements[molecule.atoms[surface.owners[t]].atomic_number];
    while (mesh.parts.size() <= material) mesh.parts.push_back({.indices = {}, .material = mesh.parts.size()});
    auto& indices = mesh.parts[material].indices;
    indices.insert(indices.end(), surface.triangles.begin() + std::ptrdiff_t(3 * t),
                   surface.triangles.begin() + std::ptrdiff_t(3 * t + 3));
  }
  scene.meshes.push_back(std::move(mesh));
  scene.nodes.push_back({.name = scene.title, .mesh = 0});
}

}  // namespace

GltfMesh ballMesh() {
  // An icosahedron, each triangle cut in four three times.
  const float g = 0.5f * (1.0f + std::sqrt(5.0f));
  std::vector<glm::vec3> places{{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                                {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  for (glm::vec3& p : places) p = glm::normalize(p);
  std::vector<std::uint32_t> faces{0, 11, 5,  0, 5,  1, 0, 1, 7, 0, 7,  10, 0, 10, 11, 1, 5, 9, 5, 11,
                                   4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3,  9,  4, 3,  4,  2, 3, 2, 6, 3,
                                   6, 8,  3,  8, 9,  4, 9, 5, 2, 4, 11, 6,  2, 10, 8,  6, 7, 9, 8, 1};
  for (int round = 0; round < 3; ++round) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [it, made] = middles.try_emplace(std::minmax(a, b), std::uint32_t(places.size()));
      if (made) places.push_back(glm::normalize(places[a] + places[b]));
      return it->second;
    };
    std::vector<std::uint32_t> finer;
    for (std::size_t k = 0; k < faces.size(); k += 3) {
      const std::uint32_t a = faces[k], b = faces[k + 1], c = faces[k + 2], ab = middle(a, b), bc = middle(b, c),
                          ca = middle(c, a);
      finer.insert(finer.end(), {a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca});
    }
    faces = std::move(finer);
  }
  return {.name = "ball", .places = places, .normals = places, .parts = {{.indices = std::move(faces), .material = 0}}};
}

Expected<GltfScene> exportMolecule(const Molecule& molecule, const ExportOptions& options) {
  if (molecule.atoms.empty())
    return Problem{.file = {}, .message = tr("there are no atoms to save"), .remedy = tr("open a molecule first")};
  std::vector<Ball> balls = molecule.balls();
  for (Ball& b : balls) b.radius_A += options.probe_A;
  Vec3 low = balls[0].centre_A, high = low;
  for (const Ball& b : balls) {
    low = glm::min(low, b.centre_A - b.radius_A);
    high = glm::max(high, b.centre_A + b.radius_A);
  }
  const Vec3 middle_A = 0.5 * (low + high);
  GltfScene scene;
  scene.title = molecule.id.empty() ? "molecule" : molecule.id;
  scene.notes = {{"unit", number(1.0 / options.units_per_nm, "nm")},
                 {"middle", number(middle_A.x, "") + number(middle_A.y, "") +
                                number(middle_A.z, "angstrom in the molecule's file")},
                 {"probe", number(options.probe_A, "angstrom")}};
  if (!molecule.title.empty()) scene.notes.push_back({"title", molecule.title});
  if (options.style == ExportStyle::Balls) {
    addBalls(molecule, options, middle_A, scene);
    return scene;
  }
  const double step_A = options.step_A > 0 ? options.step_A : usualStep_A(balls);
  if (cellCount(balls, step_A) > kMostCells)
    return Problem{
        .file = {},
        .message = trf("a surface with steps of {0} is too fine for a molecule of this size", number(step_A, "A")),
        .remedy = trf("take coarser steps, {0} for example", number(usualStep_A(balls), "A"))};
  scene.notes.push_back({"step", number(step_A, "angstrom")});
  addSurface(molecule, options, balls, step_A, scene);
  return scene;
}

}  // namespace moltact
