#include "engine/lesson/scripted_learner/virtual_touch.h"

#include "engine/lesson/lesson_region.h"
#include "engine/workspace/fit_workspace.h"
#include "engine/workspace/scale.h"

namespace moltact {

void VirtualTouch::begin(std::shared_ptr<const Molecule> molecule, const SceneSpec& scene) {
  if (molecule != molecule_) {
    molecule_ = std::move(molecule);
    balls_ = std::make_shared<const BallScene>(molecule_->balls());
  }
  settings_.workspace = fitWorkspace(*balls_);
  if (const auto region = magnifiedRegion(scene, *molecule_))
    settings_.workspace = magnified(settings_.workspace, *region, DeviceSpecs{});
  scene_ = scene;
  stage_ = {};
  settings_.probe_A = scene.probe_A;
  settings_.stiffness_N_per_mm = scene.stiffness_N_per_mm;
  settings_.force_on = scene.force;
  exact_ = methods().front().make(balls_, scene.probe_A);
  method_ = {};
  useMethod(scene.method);
  place({balls_->high_A() + Vec3(2.0 * scene.probe_A + 5.0)});
}

void VirtualTouch::setStage(const TaskStage& stage) {
  if (stage == stage_) return;
  settings_.probe_A = stage.probe_A.value_or(scene_.probe_A);
  settings_.stiffness_N_per_mm = stage.stiffness_N_per_mm.value_or(scene_.stiffness_N_per_mm);
  if (stage.method != stage_.method) useMethod(stage.method.empty() ? scene_.method : stage.method);
  stage_ = stage;
}

void VirtualTouch::useMethod(std::string_view name) {
  const Method* method = findMethod(name);
  if (!method || method->name == method_) return;
  method_ = method->name;
  felt_ = interactionKinds().front().make({balls_, method, settings_.probe_A});
  ++settings_.discontinuities;
}

void VirtualTouch::place(PointA hip) {
  hip_ = hip;
  ++pose_.discontinuities;
  exact_->reset();
}

TouchSample VirtualTouch::tick(PointA hip) {
  hip_ = hip;
  pose_.position = settings_.workspace.toDevice(hip);
  const ServoSample s = step_.tick(settings_, felt_.get(), pose_);
  ++ticks_;
  if (s.placed) exact_->reset();
  exact_->setProbe(s.probe_A);
  const bool is_exact = method_ == methods().front().name;
  TouchSample sample = touchSampleOf(s, method_, is_exact ? s.contact : exact_->step(s.hip));
  sample.time_s = time_s();  // of this clock, which goes on from scene to scene
  return sample;
}

HandPlanInput VirtualTouch::view(int attempt) const {
  return {.balls = *balls_,
          .probe_A = settings_.probe_A,
          .N_per_A = settings_.stiffness_N_per_mm / settings_.workspace.A_per_mm,
          .hip = hip_,
          .attempt = attempt};
}

}  // namespace moltact
