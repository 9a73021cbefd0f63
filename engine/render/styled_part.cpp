#include "engine/render/styled_part.h"

#include <algorithm>

#include "engine/render/cartoon.h"
#include "engine/render/sticks.h"
#include "engine/structure/bonds.h"

namespace moltact {
namespace {

constexpr double kStick_A = 0.22, kThinStick_A = 0.14, kLine_A = 0.05,
                 kSmallBall = 0.24;    // the last of an atom's radius
constexpr double kLeastProbe_A = 0.2;  // a surface of no probe would be the spheres themselves

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

StyledPart::StyledPart(const StyledAtoms& what, const ViewScene& scene, const MoleculeModel& model)
    : what_(what),
      hidden_(scene.look.hidden),
      molecule_(scene.molecule),
      probe_A_(scene.probe_A),
      painted_(model.painted) {
  shown_.assign(model.scene.size(), what.atoms ? 0 : 1);
  if (what.atoms)
    for (const std::uint32_t a : *what.atoms)
      if (a < shown_.size()) shown_[a] = 1;
  if (hidden_)
    for (const std::uint32_t a : *hidden_)
      if (a < shown_.size()) shown_[a] = 0;
  if (what.style == DrawStyle::Surface) {
    std::vector<Ball> balls;
    std::vector<std::uint32_t> atoms;
    for (std::uint32_t a = 0; a < shown_.size(); ++a)
      if (shown_[a]) {
        balls.push_back(model.scene[a]);
        atoms.push_back(a);
      }
    surface_ = solventExcluded(balls, std::max(probe_A_, kLeastProbe_A));
    for (auto* of : {&surface_.owner, &surface_.second})
      for (std::uint32_t& o : *of) o = atoms[o];
  }
  findShapes(model);
}

bool StyledPart::fits(const StyledAtoms& what, const ViewScene& scene) const {
  return what.style == what_.style && what.atoms == what_.atoms && what.opacity == what_.opacity &&
         scene.look.hidden == hidden_ && scene.molecule == molecule_ &&
         (what.style != DrawStyle::Surface || scene.probe_A == probe_A_);
}

void StyledPart::paint(const MoleculeModel& model) {
  if (model.painted == painted_) return;
  painted_ = model.painted;
  findShapes(model);
}

void StyledPart::findShapes(const MoleculeModel& model) {
  const Molecule& m = *molecule_;
  MeshPiece piece;
  std::vector<Ball> shading;  // what stands in the light's way
  balls_.clear();
  const auto addBonds = [&](std::span<const std::uint8_t> atoms, double stick_A, double ball_A, double ball_share) {
    append(piece, sticks(m, findBonds(m), atoms, model.colour, stick_A));
    for (std::uint32_t a = 0; a < atoms.size(); ++a)
      if (atoms[a]) {
        const double radius = std::max(ball_A, ball_share * m.atoms[a].radius_A);
        balls_.push_back({a, float(radius)});
        shading.push_back({m.atoms[a].position.A, std::max(radius, 0.5)});
      }
  };
  switch (what_.style) {
    case DrawStyle::Spheres:
      return;
    case DrawStyle::BallAndStick:
      addBonds(shown_, kThinStick_A, 0.0, kSmallBall);
      break;
    case DrawStyle::Sticks:
      addBonds(shown_, kStick_A, kStick_A, 0.0);
      break;
    case DrawStyle::Lines:
      addBonds(shown_, kLine_A, kLine_A, 0.0);
      break;
    case DrawStyle::Cartoon: {
      piece = cartoon(m, shown_, model.colour);
      for (std::size_t v = 0; v < piece.vertices.size(); v += 14)
        shading.push_back({piece.origin_A + Vec3(piece.vertices[v].place), 0.7});
      std::vector<std::uint8_t> others(shown_);
      for (const Residue& r : m.residues)
        if (inCartoon(r)) std::fill_n(others.begin() + r.first_atom, r.atom_count, std::uint8_t(0));
      if (std::find(others.begin(), others.end(), 1) != others.end()) addBonds(others, kStick_A, kStick_A, kSmallBall);
      break;
    }
    case DrawStyle::Surface:
      piece = surface_.piece;
      for (std::size_t v = 0; v < piece.vertices.size(); ++v)
        piece.vertices[v].colour =
            mixed(model.colour[surface_.owner[v]], model.colour[surface_.second[v]], surface_.share[v]);
      break;
  }
  mesh_ = std::make_unique<GpuMesh>(piece);
  if (shading.empty()) return;
  const OcclusionField field = occlusionField(shading);
  occlusion_.emplace().upload(field);
  for (SmallBall& b : balls_) b.wide = field.wideRound(m.atoms[b.atom].position.A, b.radius_A);
}

}  // namespace moltact
