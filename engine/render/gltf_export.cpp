#include "engine/render/gltf_export.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <tuple>

#include "engine/gltf/closed_surface.h"
#include "engine/language/catalogue.h"
#include "engine/molecule/elements.h"
#include "engine/render/molecule_model.h"
#include "engine/render/sticks.h"
#include "engine/render/style_shapes.h"

namespace moltact {
namespace {

constexpr double kNm_per_A = 0.1;

std::string number(double value, const char* unit) {
  char text[64];
  std::snprintf(text, sizeof text, "%.6g %s", value, unit);
  return text;
}

std::uint32_t opaque(std::uint32_t colour) { return colour | 0xFF000000u; }

// Materials by colour and opacity in order of first use; named by the element if the colour denotes one.
class Materials {
 public:
  Materials(GltfScene& scene, const Molecule& molecule, const std::vector<std::uint32_t>& colours, bool by_element)
      : scene_(scene), molecule_(molecule), colours_(colours), by_element_(by_element) {}

  std::uint32_t colourOf(std::uint32_t atom) const { return colours_[atom]; }
  std::size_t ofAtom(std::uint32_t atom, float opacity) {
    return of(colours_[atom], opacity,
              by_element_ ? std::string(element(molecule_.atoms[atom].atomic_number).name) : std::string());
  }
  std::size_t of(std::uint32_t colour, float opacity, std::string name = {}) {
    colour = opaque(colour);
    const auto [it, made] = known_.try_emplace({colour, opacity, name}, scene_.materials.size());
    if (made) {
      const auto part = [&](unsigned shift) { return float(colour >> shift & 255u) / 255.0f; };
      if (name.empty()) {
        char text[16];
        std::snprintf(text, sizeof text, "#%02x%02x%02x", colour & 255u, colour >> 8 & 255u, colour >> 16 & 255u);
        name = text;
      }
      scene_.materials.push_back({std::move(name), {part(0), part(8), part(16)}, opacity});
    }
    return it->second;
  }

 private:
  GltfScene& scene_;
  const Molecule& molecule_;
  const std::vector<std::uint32_t>& colours_;
  const bool by_element_;
  std::map<std::tuple<std::uint32_t, float, std::string>, std::size_t> known_;
};

// The sphere mesh of each material occurs once, and the spheres of each chain share a parent node.
class Spheres {
 public:
  Spheres(GltfScene& scene, Materials& materials, const Molecule& molecule, const Vec3& middle_A, double unit)
      : scene_(scene), materials_(materials), molecule_(molecule), middle_(middle_A), unit_(unit) {}

  void add(std::uint32_t atom, double radius_A, float opacity) {
    const std::size_t material = materials_.ofAtom(atom, opacity);
    const auto [mesh, new_mesh] = mesh_of_.try_emplace(material, scene_.meshes.size());
    if (new_mesh) {
      GltfMesh made = sphere_;
      made.name = scene_.materials[material].name;
      made.parts[0].material = material;
      scene_.meshes.push_back(std::move(made));
    }
    scene_.nodes.push_back({.name = molecule_.describe(atom),
                            .mesh = mesh->second,
                            .parent = groupOf(atom),
                            .place = glm::vec3((molecule_.spheres[atom].centre_A - middle_) * unit_),
                            .scale = float(radius_A * unit_)});
  }

 private:
  std::size_t groupOf(std::uint32_t atom) {
    const std::uint32_t residue = molecule_.atoms[atom].residue;
    if (residue == kNoResidue) return 0;
    const std::uint32_t chain = molecule_.residues[residue].chain;
    const auto [group, new_group] = group_of_.try_emplace(chain, scene_.nodes.size());
    if (new_group) scene_.nodes.push_back({.name = "chain " + molecule_.chains[chain].name.string(), .parent = 0});
    return group->second;
  }

  GltfScene& scene_;
  Materials& materials_;
  const Molecule& molecule_;
  const Vec3 middle_;
  const double unit_;
  const GltfMesh sphere_ = sphereMesh();
  std::map<std::size_t, std::size_t> mesh_of_;     // by material
  std::map<std::uint32_t, std::size_t> group_of_;  // node of each chain
};

// Triangles with one material per colour, that of the first corner.
void addPiece(const MeshPiece& piece, std::string name, float opacity, const Vec3& middle_A, double unit,
              Materials& materials, GltfScene& scene) {
  if (piece.indices.empty()) return;
  GltfMesh mesh{.name = std::move(name), .places = {}, .normals = {}, .parts = {}};
  for (const MeshPiece::Vertex& v : piece.vertices) {
    mesh.places.push_back(glm::vec3((piece.origin_A + Vec3(v.place) - middle_A) * unit));
    mesh.normals.push_back(v.normal);
  }
  std::map<std::size_t, std::size_t> part_of;
  for (std::size_t k = 0; k + 2 < piece.indices.size(); k += 3) {
    const std::size_t material = materials.of(piece.vertices[piece.indices[k]].colour, opacity);
    const auto [part, made] = part_of.try_emplace(material, mesh.parts.size());
    if (made) mesh.parts.push_back({.indices = {}, .material = material});
    auto& indices = mesh.parts[part->second].indices;
    indices.insert(indices.end(), piece.indices.begin() + std::ptrdiff_t(k),
                   piece.indices.begin() + std::ptrdiff_t(k + 3));
  }
  scene.nodes.push_back({.name = mesh.name, .mesh = scene.meshes.size(), .parent = 0});
  scene.meshes.push_back(std::move(mesh));
}

void addStyles(const Molecule& molecule, const ExportOptions& options, const std::vector<std::uint8_t>& seen,
               const Vec3& middle_A, Materials& materials, GltfScene& scene) {
  const double unit = kNm_per_A * options.units_per_nm;
  Spheres spheres(scene, materials, molecule, middle_A, unit);
  scene.nodes.push_back({.name = scene.title});
  std::vector<StyledAtoms> styles = options.look.styles;
  if (styles.empty()) styles.emplace_back();
  std::vector<std::uint32_t> colours(molecule.atoms.size());
  for (std::uint32_t a = 0; a < colours.size(); ++a) colours[a] = materials.colourOf(a);
  FoundStructure found;
  for (const StyledAtoms& what : styles) {
    std::vector<std::uint8_t> shown = seen;
    if (what.atoms) {
      std::vector<std::uint8_t> named(seen.size(), 0);
      for (const std::uint32_t a : *what.atoms)
        if (a < named.size()) named[a] = seen[a];
      shown = std::move(named);
    }
    if (std::find(shown.begin(), shown.end(), 1) == shown.end()) continue;
    if (what.style == DrawStyle::Spheres) {
      for (std::uint32_t a = 0; a < shown.size(); ++a)
        if (shown[a]) spheres.add(a, molecule.spheres[a].radius_A + options.probe_A, what.opacity);
      continue;
    }
    SolventExcluded surface;
    if (infoOf(what.style).uses_probe) {
      surface = surfaceOf(molecule, shown, options.probe_A > 0.0 ? options.probe_A : kWaterProbe_A);
      for (std::size_t v = 0; v < surface.share.size(); ++v) surface.share[v] = 0.0f;  // one colour per atom
    }
    const StyleShapes shapes = shapesOf(what.style, molecule, shown, colours, surface, found);
    addPiece(shapes.piece, std::string(nameOf(what.style)), what.opacity, middle_A, unit, materials, scene);
    for (const SmallSphere& b : shapes.spheres) spheres.add(b.atom, double(b.radius_A), what.opacity);
  }
}

// Bonds and measures are grouped by kind; the name of a measure is its value.
void addAnnotations(const ExportOptions& options, const Vec3& middle_A, Materials& materials, GltfScene& scene) {
  constexpr double kBond_A = 0.10, kMeasure_A = 0.07;
  constexpr Colour kMeasure(0.16f, 0.18f, 0.22f);  // dark, because slides have a light background
  const double unit = kNm_per_A * options.units_per_nm;
  const Theme theme = lightTheme();
  const auto add = [&](MeshPiece& piece, PointA from, PointA to, double radius_A, const Colour& colour) {
    for (const auto& [a, b] : dashesBetween(from, to)) addStick(piece, a.A, b.A, radius_A, packColour(colour), true);
  };
  MeshPiece bonds;
  bonds.origin_A = middle_A;
  for (const auto& written : options.annotations) {
    for (const auto& [a, b] : written->bonds) add(bonds, a, b, kBond_A, theme.bond);
    for (const Annotations::Measure& m : written->measures) {
      MeshPiece measure;
      measure.origin_A = middle_A;
      for (std::size_t i = 0; i + 1 < m.places.size(); ++i)
        add(measure, m.places[i], m.places[i + 1], kMeasure_A, kMeasure);
      addPiece(measure, m.text, 1.0f, middle_A, unit, materials, scene);
    }
  }
  addPiece(bonds, "hydrogen bonds", 1.0f, middle_A, unit, materials, scene);
}

void addPrintedSurface(const ExportOptions& options, const std::vector<Sphere>& spheres,
                       const std::vector<std::uint32_t>& atoms, double step_A, Materials& materials, GltfScene& scene) {
  const ClosedSurface surface = closedSurface(spheres, step_A);
  const auto unit = float(kNm_per_A * options.units_per_nm);
  GltfMesh mesh{.name = "surface", .places = surface.places, .normals = surface.normals, .parts = {}};
  for (glm::vec3& p : mesh.places) p *= unit;
  for (std::size_t t = 0; t < surface.owners.size(); ++t) {
    const std::size_t material = materials.ofAtom(atoms[surface.owners[t]], 1.0f);
    while (mesh.parts.size() <= material) mesh.parts.push_back({.indices = {}, .material = mesh.parts.size()});
    auto& indices = mesh.parts[material].indices;
    indices.insert(indices.end(), surface.triangles.begin() + std::ptrdiff_t(3 * t),
                   surface.triangles.begin() + std::ptrdiff_t(3 * t + 3));
  }
  scene.meshes.push_back(std::move(mesh));
  scene.nodes.push_back({.name = scene.title, .mesh = 0});
}

}  // namespace

GltfMesh sphereMesh() {
  // An icosahedron, each triangle subdivided into four three times.
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
  std::vector<std::uint8_t> seen(molecule.atoms.size(), 1);
  if (options.look.hidden)
    for (const std::uint32_t a : *options.look.hidden)
      if (a < seen.size()) seen[a] = 0;
  std::vector<Sphere> spheres;
  std::vector<std::uint32_t> atoms;
  for (std::uint32_t a = 0; a < seen.size(); ++a) {
    if (!seen[a]) continue;
    spheres.push_back({molecule.spheres[a].centre_A, molecule.spheres[a].radius_A + options.probe_A});
    atoms.push_back(a);
  }
  if (spheres.empty())
    return Problem{.file = {}, .message = tr("all atoms are hidden"), .remedy = tr("show some of them")};
  Vec3 low = spheres[0].centre_A, high = low;
  for (const Sphere& b : spheres) {
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
  std::shared_ptr<const std::vector<OwnColour>> marks = options.look.marks;
  if (!options.highlighted.empty()) {
    auto with = marks ? std::make_shared<std::vector<OwnColour>>(*marks) : std::make_shared<std::vector<OwnColour>>();
    const std::uint32_t target = packColour(lightTheme().target);
    with->push_back({.atoms = options.highlighted,
                     .colour = {std::uint8_t(target), std::uint8_t(target >> 8), std::uint8_t(target >> 16)},
                     .name = {}});
    marks = std::move(with);
  }
  const std::vector<std::uint32_t> colours = atomColours(molecule, {.elements = options.colours,
                                                                    .by = options.colour_by,
                                                                    .colouring = options.look.colouring,
                                                                    .marks = marks,
                                                                    .touched = nullptr});
  Materials materials(scene, molecule, colours,
                      !options.look.colouring && !marks && options.colour_by == ColourBy::Element);
  if (!options.print) {
    addStyles(molecule, options, seen, middle_A, materials, scene);
    addAnnotations(options, middle_A, materials, scene);
    return scene;
  }
  const double step_A = options.step_A > 0 ? options.step_A : usualStep_A(spheres);
  if (cellCount(spheres, step_A) > kMaxCells)
    return Problem{
        .file = {},
        .message = trf("a surface with steps of {0} is too fine for a molecule of this size", number(step_A, "A")),
        .remedy = trf("take coarser steps, {0} for example", number(usualStep_A(spheres), "A"))};
  scene.notes.push_back({"step", number(step_A, "angstrom")});
  addPrintedSurface(options, spheres, atoms, step_A, materials, scene);
  return scene;
}

}  // namespace moltact
