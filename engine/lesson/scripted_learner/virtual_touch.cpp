#include "engine/lesson/scripted_learner/virtual_touch.h"

#include "engine/lesson/lesson_region.h"
#include "engine/lesson/scene_atoms.h"
#include "engine/structure/atom_charges.h"
#include "engine/workspace/fit_workspace.h"
#include "engine/workspace/scale.h"

namespace moltact {

void VirtualTouch::begin(std::shared_ptr<const Molecule> molecule, const SceneSpec& scene) {
  const std::vector<std::uint32_t> untouchable = untouchableAtoms(scene, *molecule);
  body_ = scene.in_hand.given() ? heldBody(molecule->spheres, heldAtoms(scene, *molecule)) : nullptr;
  if (molecule != molecule_ || spheres_->untouchable() != untouchable) {
    molecule_ = std::move(molecule);
    spheres_ = std::make_shared<const SphereGrid>(molecule_->spheres, untouchable);
  }
  settings_.workspace = fitWorkspace(*spheres_);
  if (const auto region = magnifiedRegion(scene, *molecule_))
    settings_.workspace = magnified(settings_.workspace, *region, DeviceSpecs{});
  scene_ = scene;
  stage_ = {};
  felt_ = nullptr;
  exact_ = nullptr;
  feelWith(scene.touch);
  const double room_A = body_ ? body_->reach_A : 2.0 * scene.touch.probe_A;
  place({{spheres_->high_A() + Vec3(room_A + 5.0)}});
}

void VirtualTouch::setStage(const TaskStage& stage) {
  if (stage == stage_) return;
  if (stage.removed != stage_.removed) {
    spheres_ = std::make_shared<const SphereGrid>(molecule_->spheres,
                                                  atomsOfEither(untouchableAtoms(scene_, *molecule_), stage.removed));
    felt_ = nullptr;
    exact_ = nullptr;
  }
  TouchSetup touch = touch_;
  stage.touch.replace(stage_.touch, scene_.touch, touch);
  feelWith(touch);
  stage_ = stage;
}

void VirtualTouch::useMethod(std::string_view name) {
  TouchSetup touch = touch_;
  touch.method = name;
  feelWith(touch);
}

void VirtualTouch::feelWith(const TouchSetup& wanted) {
  const TouchSetup touch = resolveInteraction(wanted, body_ != nullptr);
  if (!felt_ || !sameConstruction(touch, touch_)) {
    std::unique_ptr<Interaction> made = makeInteraction({spheres_, touch, body_, chemistryFor(touch, *molecule_)});
    if (!made) return;
    felt_ = std::move(made);
    ++settings_.discontinuities;
  }
  const TouchSetup reference = referenceOf(touch);
  if (!exact_ || !sameConstruction(reference, referenceOf(touch_))) exact_ = makeInteraction({spheres_, reference});
  is_reference_ = sameConstruction(touch, reference);
  touch_ = touch;
  settings_.take(touch);
  method_ = findMethod(touch.method)->name;
}

void VirtualTouch::place(const PoseA& hand) {
  hand_ = hand;
  ++pose_.discontinuities;
  exact_->reset();
}

TouchSample VirtualTouch::tick(const PoseA& hand) {
  hand_ = hand;
  pose_.position = settings_.workspace.toDevice(hand.place);
  pose_.orientation = glm::conjugate(glm::quat_cast(settings_.workspace.rotation)) * hand.orientation;
  const ServoSample s = step_.tick(settings_, felt_.get(), pose_);
  ++ticks_;
  if (s.contact_reset) exact_->reset();
  exact_->setProbe(s.probe_A);
  // Methods are not judged with a held body.
  TouchSample sample =
      touchSampleOf(s, method_, is_reference_ || body_ ? s.contact : exact_->respond({s.hip, s.orientation}).contact);
  sample.time_s = time_s();  // on the virtual clock, which continues across scenes
  return sample;
}

HandPlanInput VirtualTouch::view(int attempt) const {
  return {.spheres = *spheres_,
          .probe_A = settings_.probe_A,
          .N_per_A = settings_.stiffness_N_per_mm / settings_.workspace.A_per_mm,
          .hip = hand_.place,
          .attempt = attempt,
          .body = body_.get(),
          .orientation = hand_.orientation};
}

}  // namespace moltact
