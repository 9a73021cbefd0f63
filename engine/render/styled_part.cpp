#include "engine/render/styled_part.h"

#include <algorithm>
#include <utility>

namespace moltact {

StyledPart::StyledPart(const StyledAtoms& what, const ViewScene& scene, const MoleculeModel& model)
    : what_(what),
      models_balls_(what.style == DrawStyle::Spheres || model.byResidue()),
      hidden_(scene.look.hidden),
      molecule_(scene.molecule),
      most_single_atoms_(scene.most_single_atoms),
      probe_A_(scene.probe_A),
      painted_(model.painted) {
  shown_.assign(model.atoms(), what.atoms ? 0 : 1);
  if (what.atoms)
    for (const std::uint32_t a : *what.atoms)
      if (a < shown_.size()) shown_[a] = 1;
  if (hidden_)
    for (const std::uint32_t a : *hidden_)
      if (a < shown_.size()) shown_[a] = 0;
  shown_ = model.shownBalls(std::move(shown_));
  if (!models_balls_ && infoOf(what.style).uses_probe) surface_ = surfaceOf(*molecule_, shown_, probe_A_);
  findShapes(model);
}

bool StyledPart::fits(const StyledAtoms& what, const ViewScene& scene) const {
  return what.style == what_.style && what.atoms == what_.atoms && what.opacity == what_.opacity &&
         scene.look.hidden == hidden_ && scene.molecule == molecule_ && scene.most_single_atoms == most_single_atoms_ &&
         (models_balls_ || !infoOf(what.style).uses_probe || scene.probe_A == probe_A_);
}

void StyledPart::paint(const MoleculeModel& model) {
  if (model.painted == painted_) return;
  painted_ = model.painted;
  findShapes(model);
}

void StyledPart::findShapes(const MoleculeModel& model) {
  if (models_balls_) return;
  StyleShapes shapes = shapesOf(what_.style, *molecule_, shown_, model.colour, surface_);
  balls_ = std::move(shapes.balls);
  mesh_ = std::make_unique<GpuMesh>(shapes.piece);
  if (shapes.shading.empty()) return;
  const OcclusionField field = occlusionField(shapes.shading);
  occlusion_.emplace().upload(field);
  for (SmallBall& b : balls_) b.wide = field.wideRound(molecule_->atoms[b.atom].position.A, b.radius_A);
}

}  // namespace moltact
