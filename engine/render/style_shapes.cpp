#include "engine/render/style_shapes.h"

#include <algorithm>

#include "engine/render/cartoon.h"
#include "engine/render/molecule_model.h"
#include "engine/render/sticks.h"

namespace moltact {
namespace {

constexpr double kStick_A = 0.22, kThinStick_A = 0.14, kLine_A = 0.05,
                 kSmallSphere = 0.24;  // the last is a fraction of the atom's radius
constexpr double kMinProbe_A = 0.2;    // without a probe the surface would be the spheres themselves

std::uint32_t mixed(std::uint32_t a, std::uint32_t b, float share) {
  const auto part = [&](unsigned shift) {
    return glm::mix(float(a >> shift & 255u), float(b >> shift & 255u), share) / 255.0f;
  };
  return packColour({part(0), part(8), part(16)});
}

void append(MeshPiece& to, const MeshPiece& from) {
  const auto first = std::uint32_t(to.vertices.size());
  const glm::vec3 off(from.origin_A - to.origin_A);
  for (MeshPiece::Vertex v : from.vertices) {
    v.place += off;
    to.vertices.push_back(v);
  }
  for (const std::uint32_t i : from.indices) to.indices.push_back(first + i);
}

}  // namespace

SolventExcluded surfaceOf(const Molecule& molecule, std::span<const std::uint8_t> shown, double probe_A,
                          SurfaceProgress* progress) {
  std::vector<Sphere> spheres;
  std::vector<std::uint32_t> atoms;
  for (std::uint32_t a = 0; a < shown.size(); ++a)
    if (shown[a]) {
      spheres.push_back(molecule.spheres[a]);
      atoms.push_back(a);
    }
  SolventExcluded surface = solventExcluded(spheres, std::max(probe_A, kMinProbe_A), progress);
  for (auto* of : {&surface.owner, &surface.second})
    for (std::uint32_t& o : *of) o = atoms[o];
  return surface;
}

StyleShapes shapesOf(DrawStyle style, const Molecule& m, std::span<const std::uint8_t> shown,
                     std::span<const std::uint32_t> colours, const SolventExcluded& surface, FoundStructure& found) {
  StyleShapes out;
  MeshPiece& piece = out.piece;
  const auto addBonds = [&](std::span<const std::uint8_t> atoms, double stick_A, double sphere_A, double sphere_share) {
    append(piece, sticks(m, found.bonds(m), atoms, colours, stick_A));
    for (std::uint32_t a = 0; a < atoms.size(); ++a)
      if (atoms[a]) {
        const double radius = std::max(sphere_A, sphere_share * m.spheres[a].radius_A);
        out.spheres.push_back({a, float(radius)});
        out.shading.push_back({m.spheres[a].centre_A, std::max(radius, 0.5)});
      }
  };
  switch (style) {
    case DrawStyle::Spheres:
      break;
    case DrawStyle::BallAndStick:
      addBonds(shown, kThinStick_A, 0.0, kSmallSphere);
      break;
    case DrawStyle::Sticks:
      addBonds(shown, kStick_A, kStick_A, 0.0);
      break;
    case DrawStyle::Lines:
      addBonds(shown, kLine_A, kLine_A, 0.0);
      break;
    case DrawStyle::Cartoon: {
      piece = cartoon(m, shown, colours, found.secondary(m));
      for (std::size_t v = 0; v < piece.vertices.size(); v += 14)
        out.shading.push_back({piece.origin_A + Vec3(piece.vertices[v].place), 0.7});
      std::vector<std::uint8_t> others(shown.begin(), shown.end());
      for (const Residue& r : m.residues)
        if (inCartoon(r)) std::fill_n(others.begin() + r.first_atom, r.atom_count, std::uint8_t(0));
      if (std::find(others.begin(), others.end(), 1) != others.end())
        addBonds(others, kStick_A, kStick_A, kSmallSphere);
      break;
    }
    case DrawStyle::Surface:
      piece = surface.piece;
      for (std::size_t v = 0; v < piece.vertices.size(); ++v)
        piece.vertices[v].colour = mixed(colours[surface.owner[v]], colours[surface.second[v]], surface.share[v]);
      break;
  }
  return out;
}

}  // namespace moltact
