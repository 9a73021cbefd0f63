#include "engine/lesson/scripted_learner/virtual_touch.h"

#include "engine/haptics/guide/guide_layer.h"
#include "engine/lesson/lesson_region.h"
#include "engine/lesson/scene_atoms.h"
#include "engine/servo/reference_interaction.h"
#include "engine/structure/interaction_input.h"
#include "engine/workspace/fit_workspace.h"
#include "engine/workspace/scale.h"

namespace moltact {

void VirtualTouch::begin(std::shared_ptr<const Molecule> molecule, const SceneSpec& scene) {
  const std::vector<std::uint32_t> untouchable = untouchableAtoms(scene, *molecule);
  body_ = scene.in_hand.given() ? heldBody(*molecule, heldAtoms(scene, *molecule)) : nullptr;
  const bool moved = spheres_ && spheres_->spheres().data() != molecule_->spheres.data();
  if (molecule != molecule_ || moved || spheres_->untouchable() != untouchable) {
    molecule_ = std::move(molecule);
    spheres_ = std::make_shared<const SphereGrid>(molecule_->spheres, untouchable);
  }
  settings_.workspace = fitWorkspace(*spheres_);
  if (const auto region = magnifiedRegion(scene, *molecule_))
    settings_.workspace = magnified(settings_.workspace, *region, DeviceSpecs{});
  scene_ = scene;
  stage_ = {};
  guide_.reset();
  setStructures(nullptr);
  felt_ = nullptr;
  exact_ = nullptr;
  feelWith(scene.touch);
  const double room_A = body_ ? body_->reach_A : 2.0 * scene.touch.probe_A;
  place({{spheres_->high_A() + Vec3(room_A + 5.0)}});
}

void VirtualTouch::setStructures(std::shared_ptr<const TwoStates> states) {
  states_ = std::move(states);
  structures_.clear();
  motion_ = nullptr;
  fraction_ = 0.0;
  share_ = scene_.then.share;
  if (!states_) return;
  for (const std::vector<Sphere>& spheres : {states_->first, states_->second})
    structures_.push_back(std::make_shared<const SphereGrid>(spheres, spheres_->untouchable()));
}

void VirtualTouch::moveTo(double share) {
  constexpr double kFastest_A_per_s = 8.0, kShortest_s = 1.5;
  if (!states_ || moving() || share == share_) return;
  const std::vector<Sphere> to = states_->at(share);
  const std::span<const Sphere> from = spheres_->spheres();
  double farthest_A = 0.0;
  for (std::size_t i = 0; i < to.size(); ++i)
    if (spheres_->touchable(i)) farthest_A = std::max(farthest_A, glm::distance(from[i].centre_A, to[i].centre_A));
  const double takes_s = std::max(kShortest_s, farthest_A / kFastest_A_per_s);
  auto motion =
      SphereMotion::make(from, to, std::min(int(takes_s / kTick_s), SphereMotion::kMaxTicks), spheres_->untouchable());
  if (!motion) return;
  motion_ = *std::move(motion);
  fraction_ = 0.0;
  share_ = share;
}

void VirtualTouch::setStage(const TaskStage& stage) {
  if (stage == stage_) return;
  if (stage.removed != stage_.removed) {
    spheres_ = std::make_shared<const SphereGrid>(spheres_->spheres(),
                                                  atomsOfEither(untouchableAtoms(scene_, *molecule_), stage.removed));
    motion_ = nullptr;
    felt_ = nullptr;
    exact_ = nullptr;
  }
  if (stage.in_hand != stage_.in_hand) {
    body_ = heldBody(*molecule_, stage.in_hand.empty() ? heldAtoms(scene_, *molecule_) : stage.in_hand);
    felt_ = nullptr;
    exact_ = nullptr;
  }
  TouchSetup touch = touch_;
  stage.touch.replace(stage_.touch, scene_.touch, touch);
  feelWith(touch);
  if (stage.body_turned && (stage.body_turned != stage_.body_turned || stage.presentation != stage_.presentation))
    place({stage.body_begins.value_or(hand_.place), *stage.body_turned});
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
    std::unique_ptr<Interaction> next = made(touch);
    if (!next) return;
    felt_ = std::move(next);
    ++settings_.discontinuities;
  }
  const TouchSetup reference = referenceOf(touch);
  // No method is judged with a body.
  if (body_ || sameConstruction(touch, reference))
    exact_ = nullptr;
  else if (!exact_ || !sameConstruction(reference, referenceOf(touch_)))
    exact_ = makeInteraction(interactionInput(reference, *molecule_, spheres_));
  touch_ = touch;
  settings_.take(touch);
  method_ = findMethod(touch.method)->name;
}

std::unique_ptr<Interaction> VirtualTouch::made(const TouchSetup& touch) const {
  std::unique_ptr<Interaction> out = makeInteraction(interactionInput(touch, *molecule_, spheres_, body_));
  if (!out || !guide_) return out;
  return std::make_unique<GuideLayer>(std::move(out), guide_->felt(settings_.workspace.A_per_mm));
}

// The contact begins anew with the force, as in the window.
void VirtualTouch::setGuide(const std::optional<TaskGuide>& guide) {
  const bool alike = guide.has_value() == guide_.has_value() && (!guide || guide->feelsLike(*guide_));
  guide_ = guide;
  if (alike || !felt_) return;
  std::unique_ptr<Interaction> next = made(touch_);
  if (!next) return;
  // Led from outside along the contact, so that the hand keeps it.
  const Vec3 outward = last_scp_A_ ? *last_scp_A_ - hand_.place.A : Vec3(0.0);
  if (const double depth_A = glm::length(outward); depth_A > 0.0)
    for (double out_A = 1e-6; out_A < 0.1; out_A *= 1.5)
      if (next->respond({{*last_scp_A_ + outward * (out_A / depth_A)}, hand_.orientation}).contact.fault == Fault::None)
        break;
  next->respond(hand_);
  felt_ = std::move(next);
}

void VirtualTouch::place(const PoseA& hand) {
  hand_ = hand;
  ++pose_.discontinuities;
  if (exact_) exact_->reset();
}

TouchSample VirtualTouch::tick(const PoseA& hand) {
  hand_ = hand;
  pose_.position = settings_.workspace.toDevice(hand.place);
  pose_.orientation = glm::conjugate(glm::quat_cast(settings_.workspace.rotation)) * hand.orientation;
  const bool moves = moving();
  if (moves) fraction_ = std::min(1.0, fraction_ + 1.0 / motion_->ticks());
  const ServoSample s = step_.tick(settings_, felt_.get(), pose_, {}, {motion_.get(), fraction_});
  ++ticks_;
  last_scp_A_ = s.contact.touching() ? std::optional(s.contact.scp.A) : std::nullopt;
  if (exact_) followTick(*exact_, s, motion_.get());
  if (motion_ && moves && !moving())
    spheres_ = std::make_shared<const SphereGrid>(motion_->at(1.0), spheres_->untouchable());
  TouchSample sample = touchSampleOf(s, method_, exact_ ? exact_->respond({s.hip, s.orientation}).contact : s.contact);
  sample.time_s = time_s();  // on the virtual clock, which continues across scenes
  return sample;
}

HandPlanInput VirtualTouch::view(int attempt) const {
  HandPlanInput out{.spheres = *spheres_,
                    .probe_A = settings_.probe_A,
                    .N_per_A = settings_.stiffness_N_per_mm / settings_.workspace.A_per_mm,
                    .hip = hand_.place,
                    .attempt = attempt,
                    .body = body_.get(),
                    .orientation = hand_.orientation};
  for (std::size_t k = 0; k < structures_.size(); ++k) out.structures.push_back({double(k), structures_[k].get()});
  return out;
}

}  // namespace moltact
