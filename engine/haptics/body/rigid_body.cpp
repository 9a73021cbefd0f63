#include "engine/haptics/body/rigid_body.h"

#include <algorithm>
#include <utility>

namespace moltact {

RigidBody::RigidBody(std::shared_ptr<const HeldBody> body, const MakeSphere& make, std::size_t shared_bytes)
    : body_(std::move(body)), shared_bytes_(shared_bytes) {
  spheres_.reserve(body_->balls.size());
  for (const Ball& ball : body_->balls) spheres_.push_back(make(ball.radius_A));
}

Response RigidBody::respond(const PoseA& pose) noexcept {
  Response out;
  springs_ = 1.0;
  const bool place = finite(pose.place.A);
  if (place) out.contact.scp = pose.place;
  // Before any of its atoms has gone on.
  if (!place || !rotates(pose.orientation) || glm::length(pose.place.A) > kFarthest_A - body_->reach_A) {
    out.contact.fault = Fault::NotFinite;
    return out;
  }
  const glm::dmat3 axes = glm::mat3_cast(glm::normalize(pose.orientation));  // a device's is of length 1 to 1e-3 only
  double springs = 0.0, farthest_A2 = -1.0;
  bool inside = false;
  for (std::size_t i = 0; i < spheres_.size(); ++i) {
    const Vec3 lever = axes * body_->balls[i].centre_A;
    const Response felt = spheres_[i]->respond({{pose.place.A + lever}, pose.orientation});
    const Contact& c = felt.contact;
    inside = c.fault == Fault::StartedInside;
    if (inside) break;
    if (!felt.felt()) continue;
    springs += spheres_[i]->parallelSprings();
    out.contact.displacement_A += c.displacement_A;
    out.contact.energy_A2 += c.energy_A2;
    out.torque_A2 += felt.torque_A2 + glm::cross(lever, c.displacement_A);
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
    return {.contact = {.scp = pose.place, .fault = Fault::StartedInside}};
  }
  springs_ = std::max(1.0, springs);
  out.contact.scp.A += out.contact.displacement_A / springs_;
  return out;
}

void RigidBody::reset() noexcept {
  for (const auto& sphere : spheres_) sphere->reset();
}

bool RigidBody::setMotion(const SphereMotion* motion) noexcept {
  // All are of one method, and the first tells of it.
  for (const auto& sphere : spheres_)
    if (!sphere->setMotion(motion)) return false;
  return true;
}

void RigidBody::advanceTo(double fraction) noexcept {
  for (const auto& sphere : spheres_) sphere->advanceTo(fraction);
}

// Its atoms model mostly the same atoms of the scene, which are counted once.
MemoryUsage RigidBody::memoryUsage() const noexcept {
  MemoryUsage out{.bytes = shared_bytes_};
  for (const auto& sphere : spheres_) {
    const MemoryUsage each = sphere->memoryUsage();
    out.atoms_modelled = std::max(out.atoms_modelled, each.atoms_modelled);
    out.bytes += each.bytes - std::min(each.bytes, shared_bytes_);
  }
  return out;
}

}  // namespace moltact
