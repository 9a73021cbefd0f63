#include "engine/bench/right_answer.h"

#include <utility>

#include "engine/haptics/friction.h"

namespace moltact::bench {

RightAnswer::RightAnswer(const scenes::Scene& scene, bool by_oracle, const std::optional<Friction>& friction)
    : scene_(scene), by_oracle_(by_oracle), friction_(friction) {
  make();
}

void RightAnswer::make() {
  const auto grid = std::make_shared<const SphereGrid>(scene_.spheres);
  oracle_ = nullptr;
  if (by_oracle_) {
    auto oracle = std::make_unique<OracleTracker>(scene_.spheres, scene_.probe_A);
    oracle_ = oracle.get();
    felt_ = std::move(oracle);
  } else {
    felt_ = std::make_unique<ExactTracker>(grid, scene_.probe_A);
  }
  if (friction_) felt_ = std::make_unique<FrictionLayer>(std::move(felt_), grid, nullptr, nullptr, *friction_);
  last_hip_.reset();
}

RightAnswer::Answer RightAnswer::step(const Vec3& hip, const Contact& given) {
  if (oracle_ && std::exchange(probe_changed_, false)) {
    // The oracle does not model how a growing surface carries the SCP; it continues from the new position.
    if (given.fault == Fault::None) oracle_->place(given.scp.A);
    return {given.touching(), given.scp.A, given.displacement_A, false};
  }
  // As in the servo loop, the surface moves with the hand at rest, and then the hand.
  if (std::exchange(moved_, false) && last_hip_) felt_->respond({{*last_hip_}, kNoRotation});
  last_hip_ = hip;
  const Contact c = felt_->respond({{hip}, kNoRotation}).contact;
  const bool known = !oracle_ || oracle_->decided();
  if (!known && given.fault == Fault::None) oracle_->place(given.scp.A);
  return {c.touching(), c.touching() ? c.scp.A : hip, c.displacement_A, known};
}

void RightAnswer::setProbe(double probe_A) {
  scene_.probe_A = probe_A;
  felt_->setProbe(probe_A);
  probe_changed_ = true;
}

void RightAnswer::setMotion(const MotionPhase& phase) {
  if (!phase.motion) return;
  felt_->setMotion(phase.motion);
  felt_->advanceTo(phase.fraction);
  moved_ = true;
}

void RightAnswer::swap(const scenes::Scene& scene) {
  scene_ = scene;
  make();
  probe_changed_ = false;
}

void RightAnswer::reset() {
  felt_->reset();
  last_hip_.reset();
}

}  // namespace moltact::bench
