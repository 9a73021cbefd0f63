#include "engine/bench/right_answer.h"

namespace moltact::bench {

RightAnswer::RightAnswer(const scenes::Scene& scene, bool by_oracle) : scene_(scene) {
  if (by_oracle)
    oracle_.emplace(scene.spheres, scene.probe_A);
  else
    exact_.emplace(std::make_shared<const SphereGrid>(scene.spheres), scene.probe_A);
}

RightAnswer::Answer RightAnswer::step(const Vec3& hip, const Contact& given) {
  if (exact_) {
    const Contact c = exact_->step({hip});
    return {c.touching(), c.touching() ? c.scp.A : hip, true};
  }
  if (moved_) {
    // The oracle does not model how a growing surface carries the SCP; it continues from the new position.
    moved_ = false;
    if (given.fault == Fault::None) oracle_->place(given.scp.A);
    return {given.touching(), given.scp.A, false};
  }
  const oracle::Oracle::Answer a = oracle_->step(hip);
  if (!a.decided && given.fault == Fault::None) oracle_->place(given.scp.A);
  return {a.contact, a.scp_A, a.decided};
}

void RightAnswer::setProbe(double probe_A) {
  scene_.probe_A = probe_A;
  if (exact_) {
    exact_->setProbe(probe_A);
    return;
  }
  oracle_.emplace(scene_.spheres, probe_A);
  moved_ = true;
}

void RightAnswer::swap(const scenes::Scene& scene) {
  scene_ = scene;
  if (exact_)
    exact_.emplace(std::make_shared<const SphereGrid>(scene.spheres), scene.probe_A);
  else
    oracle_.emplace(scene.spheres, scene.probe_A);
  moved_ = false;
}

void RightAnswer::reset() { exact_ ? exact_->reset() : oracle_->reset(); }

}  // namespace moltact::bench
