#include "app/ui/extensions/measuring.h"

#include "app/ui/lesson/scene_marks.h"
#include "engine/haptics/sweep.h"
#include "engine/language/catalogue.h"

namespace moltact {

std::optional<std::uint32_t> atomAt(const HapticSession& scene, glm::dvec2 px, glm::dvec2 view_px) {
  const TouchableModel& stage = scene.stage();
  if (!stage) return std::nullopt;
  const ViewRays rays = viewRays(scene.camera, view_px);
  const Vec3 along = rays.direction(px);
  const double far_A = glm::distance(rays.eye_A, stage.middle.A) + 2.0 * stage.reach_A;
  double from_A = 0.0;
  if (const auto& cut = scene.look.atoms.cut) {  // skip what is cut away
    const double beyond_A = glm::dot(cut->normal, rays.eye_A) - cut->offset_A, toward = -glm::dot(cut->normal, along);
    if (beyond_A > 0.0 && toward <= 0.0) return std::nullopt;
    if (beyond_A > 0.0) from_A = beyond_A / toward;
  }
  if (!(from_A < far_A)) return std::nullopt;
  const Hit hit = sweep(*stage.spheres, 0.0, rays.eye_A + along * from_A, rays.eye_A + along * far_A);
  return hit.sphere < 0 ? std::nullopt : std::optional(std::uint32_t(hit.sphere));
}

void Measuring::switchOn(bool on) {
  on_ = on;
  finish();
}

void Measuring::take(const Molecule& molecule, std::uint32_t atom) {
  if (atom >= molecule.atoms.size()) return;
  if (!atoms_.empty() && atoms_.back() == atom) {
    finish();
  } else {
    if (atoms_.size() == 4) finish();
    const bool grows = atoms_.size() >= 2;
    atoms_.push_back(atom);
    if (grows) measures_.pop_back();
    if (atoms_.size() >= 2) measures_.push_back(atoms_);
  }
  write(molecule);
}

void Measuring::clear() {
  atoms_.clear();
  measures_.clear();
  drawn_ = nullptr;
  text_.clear();
}

void Measuring::write(const Molecule& molecule) {
  auto out = std::make_shared<Annotations>();
  for (const std::vector<std::uint32_t>& atoms : measures_) out->measures.push_back(measureBetween(molecule, atoms));
  if (atoms_.size() == 1) {
    const PlacedAtom a = molecule.at(atoms_[0]);
    out->labels.push_back(
        {.at = a.position, .clear_A = a.radius_A, .text = atomLabel(molecule, atoms_[0]), .always = true});
    text_ = molecule.describe(atoms_[0]);
  } else if (!atoms_.empty()) {
    std::string names;
    for (const std::uint32_t i : atoms_) names += (names.empty() ? "" : " – ") + molecule.describe(i);
    text_ = trf("{0}: {1}", names, out->measures.back().text);
  }
  drawn_ = out->labels.empty() && out->measures.empty() ? nullptr : std::move(out);
}

void Measuring::sceneChanged() {
  if (scene_.stage().molecule == molecule_) return;
  molecule_ = scene_.stage().molecule;
  clear();
}

}  // namespace moltact
