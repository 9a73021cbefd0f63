#include "engine/render/styled_part.h"

#include <algorithm>
#include <utility>

namespace moltact {

StyledPart::StyledPart(const StyledAtoms& what, const ViewScene& scene, const MoleculeModel& model)
    : StyledPart(what, scene, model,
                 hasSurface(what, model)
                     ? surfaceOf(*scene.molecule, shownOf(what, scene.look.hidden, model), scene.probe_A)
                     : SolventExcluded{},
                 scene.molecule, scene.probe_A) {}

StyledPart::StyledPart(const StyledAtoms& what, const ViewScene& scene, const MoleculeModel& model,
                       SolventExcluded surface, std::shared_ptr<const Molecule> molecule, double probe_A)
    : what_(what),
      models_spheres_(what.style == DrawStyle::Spheres || model.byResidue()),
      hidden_(scene.look.hidden),
      molecule_(std::move(molecule)),
      max_single_atoms_(scene.max_single_atoms),
      probe_A_(probe_A),
      painted_(model.painted),
      shown_(shownOf(what, scene.look.hidden, model)),
      surface_(std::move(surface)) {
  findShapes(model);
}

bool StyledPart::hasSurface(const StyledAtoms& what, const MoleculeModel& model) {
  return what.style != DrawStyle::Spheres && !model.byResidue() && infoOf(what.style).uses_probe;
}

std::vector<std::uint8_t> StyledPart::shownOf(const StyledAtoms& what, const AtomList& hidden,
                                              const MoleculeModel& model) {
  std::vector<std::uint8_t> shown(model.atoms(), what.atoms ? 0 : 1);
  if (what.atoms)
    for (const std::uint32_t a : *what.atoms)
      if (a < shown.size()) shown[a] = 1;
  if (hidden)
    for (const std::uint32_t a : *hidden)
      if (a < shown.size()) shown[a] = 0;
  return model.shownSpheres(std::move(shown));
}

bool StyledPart::fits(const StyledAtoms& what, const ViewScene& scene) const {
  return what.style == what_.style && what.atoms == what_.atoms && what.opacity == what_.opacity &&
         scene.look.hidden == hidden_ && scene.molecule == molecule_ && scene.max_single_atoms == max_single_atoms_ &&
         (models_spheres_ || !infoOf(what.style).uses_probe || scene.probe_A == probe_A_);
}

void StyledPart::paint(const MoleculeModel& model) {
  if (model.painted == painted_) return;
  painted_ = model.painted;
  findShapes(model);
}

void StyledPart::findShapes(const MoleculeModel& model) {
  if (models_spheres_) return;
  StyleShapes shapes = shapesOf(what_.style, *molecule_, shown_, model.colour, surface_, *model.found);
  spheres_ = std::move(shapes.spheres);
  mesh_ = std::make_unique<GpuMesh>(shapes.piece);
  if (shapes.shading.empty()) return;
  const OcclusionField field = occlusionField(shapes.shading);
  occlusion_.emplace().upload(field);
  for (SmallSphere& b : spheres_) b.wide = field.wideRound(molecule_->spheres[b.atom].centre_A, b.radius_A);
}

}  // namespace moltact
