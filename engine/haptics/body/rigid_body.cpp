#include "engine/haptics/body/rigid_body.h"

#include <algorithm>
#include <utility>

namespace moltact {

RigidBody::RigidBody(std::shared_ptr<const HeldBody> body, const Method& method,
                     const std::shared_ptr<const BallScene>& scene)
    : body_(std::move(body)) {
  trackers_.reserve(body_->balls.size());
  for (const Ball& ball : body_->balls) trackers_.push_back(method.make(scene, ball.radius_A));
}

Response RigidBody::respond(const PoseA& pose) noexcept {
  Response out;
  out.contact.scp = pose.place;
  springs_ = 1.0;
  if (!rotates(pose.orientation)) {
    out.contact.fault = Fault::NotFinite;
    return out;
  }
  const glm::dmat3 axes = glm::mat3_cast(pose.orientation);
  double springs = 0.0, farthest_A2 = -1.0;
  bool inside = false;
  for (std::size_t i = 0; i < trackers_.size(); ++i) {
    const Vec3 lever = axes * body_->balls[i].centre_A;
    const Contact c = trackers_[i]->step({pose.place.A + lever});
    if (c.fault == Fault::NotFinite) {
      out = {};
      out.contact.fault = c.fault;
      return out;
    }
    inside = inside || c.fault == Fault::StartedInside;
    if (!c.touching()) continue;
    springs += trackers_[i]->parallelSprings();
    out.contact.displacement_A += c.displacement_A;
    out.contact.energy_A2 += c.energy_A2;
    out.torque_A2 += glm::cross(lever, c.displacement_A);
    if (const double far_A2 = glm::dot(c.displacement_A, c.displacement_A); far_A2 > farthest_A2) {
      farthest_A2 = far_A2;
      out.contact.atoms = c.atoms;
      out.contact.feature = c.feature;
      out.contact.normals = c.normals;
    }
  }
  if (inside) {
    // Its other atoms begin anew too, so that it is felt from nothing once it is outside.
    reset();
    out = {};
    out.contact.scp = pose.place;
    out.contact.fault = Fault::StartedInside;
    return out;
  }
  springs_ = std::max(1.0, springs);
  out.contact.scp.A += out.contact.displacement_A / springs_;
  return out;
}

void RigidBody::reset() noexcept {
  for (const auto& tracker : trackers_) tracker->reset();
}

bool RigidBody::setMotion(const SphereMotion* motion) noexcept {
  // All are of one method, and the first tells of it.
  for (const auto& tracker : trackers_)
    if (!tracker->setMotion(motion)) return false;
  return true;
}

void RigidBody::advanceTo(double fraction) noexcept {
  for (const auto& tracker : trackers_) tracker->advanceTo(fraction);
}

MemoryUsage RigidBody::memoryUsage() const noexcept {
  MemoryUsage out;
  for (const auto& tracker : trackers_) {
    const MemoryUsage each = tracker->memoryUsage();
    out.atoms_modelled += each.atoms_modelled;
    out.bytes += each.bytes;
  }
  return out;
}

}  // namespace moltact
