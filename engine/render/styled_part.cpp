#include "engine/render/styled_part.h"

#include <algorithm>

namespace moltact {
namespace {

constexpr double kLeastProbe_A = 0.2;  // a surface of no probe would be the spheres themselves

std::uint32_t mixed(std::uint32_t a, std::uint32_t b, float share) {
  const auto part = [&](unsigned shift) {
    return glm::mix(float(a >> shift & 255u), float(b >> shift & 255u), share) / 255.0f;
  };
  return packColour({part(0), part(8), part(16)});
}

}  // namespace

StyledPart::StyledPart(const StyledAtoms& what, const ViewScene& scene, const MoleculeModel& model)
    : what_(what),
      hidden_(scene.look.hidden),
      molecule_(scene.molecule),
      probe_A_(scene.probe_A),
      elements_(model.elements),
      colour_by_(model.colour_by) {
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
  if (model.elements == elements_ && model.colour_by == colour_by_) return;
  elements_ = model.elements;
  colour_by_ = model.colour_by;
  findShapes(model);
}

void StyledPart::findShapes(const MoleculeModel& model) {
  MeshPiece piece;
  std::vector<Ball> shading;  // what stands in the light's way
  balls_.clear();
  switch (what_.style) {
    case DrawStyle::Spheres:
      return;
    case DrawStyle::Surface:
      piece = surface_.piece;
      for (std::size_t v = 0; v < piece.vertices.size(); ++v)
        piece.vertices[v].colour =
            mixed(model.colour[surface_.owner[v]], model.colour[surface_.second[v]], surface_.share[v]);
      break;
  }
  mesh_ = std::make_unique<GpuMesh>(piece);
  if (!shading.empty()) occlusion_.emplace().upload(occlusionField(shading));
}

}  // namespace moltact
