#include "engine/haptics/body/rigid_body.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <utility>

namespace moltact {
namespace {

// Adds a field that acts on one of the spheres, at its lever about the body's middle.
void addField(const FeltForce& field, const Vec3& lever_A, Response& out) {
  FeltForce& sum = out.field ? *out.field : out.field.emplace();
  const double arm_A = glm::length(lever_A);
  sum.force_N += field.force_N;
  sum.torque_N_A += field.torque_N_A + glm::cross(lever_A, field.force_N);
  sum.energy_N_A += field.energy_N_A;
  sum.stiffness_N_per_A += field.stiffness_N_per_A;
  sum.rotational_stiffness_N_A +=
      field.rotational_stiffness_N_A + arm_A * (field.stiffness_N_per_A * arm_A + glm::length(field.force_N));
}

}  // namespace

RigidBody::RigidBody(std::shared_ptr<const HeldBody> body, const MakeSphere& make, std::size_t shared_bytes)
    : body_(std::move(body)), shared_bytes_(shared_bytes) {
  spheres_.reserve(body_->spheres.size());
  for (const Sphere& sphere : body_->spheres) {
    spheres_.push_back(make(sphere.radius_A));
    max_reaction_count_ += spheres_.back()->maxReactionCount();
  }
  answers_.resize(spheres_.size());
}

Response RigidBody::respond(const PoseA& pose) noexcept {
  Response out;
  held_ = 0;
  const bool place = finite(pose.place.A);
  if (place) out.contact.scp = pose.place;
  // Checked before any of the atoms has moved.
  if (!place || !rotates(pose.orientation) || glm::length(pose.place.A) > kMaxPosition_A - body_->reach_A) {
    out.contact.fault = Fault::NotFinite;
    return out;
  }
  const glm::dmat3 axes =
      glm::mat3_cast(glm::normalize(pose.orientation));  // a device's quaternion has unit length within 1e-3 only
  double stiffness_factor = 0.0, farthest_A2 = -1.0, arms_A2 = 0.0, pulls_A2 = 0.0;
  bool inside = false;
  for (std::size_t i = 0; i < spheres_.size(); ++i) {
    const Vec3 lever = axes * body_->spheres[i].centre_A;
    // Written in place, because copying a response for each sphere is expensive.
    Held& next = answers_[held_];
    const Response& felt = *::new (static_cast<void*>(&next.answer))
                               Response(spheres_[i]->respond({{pose.place.A + lever}, pose.orientation}));
    const Contact& c = felt.contact;
    inside = c.fault == Fault::StartedInside;
    if (inside) break;
    if (!felt.acts()) continue;
    next.sphere = i;
    ++held_;
    stiffness_factor += felt.stiffness_factor;
    out.contact.displacement_A += c.displacement_A;
    out.contact.energy_A2 += c.energy_A2;
    out.torque_A2 += felt.torque_A2 + glm::cross(lever, c.displacement_A);
    const double arm_A2 = glm::dot(lever, lever), pull_A2 = glm::dot(c.displacement_A, c.displacement_A);
    out.rotational_A2 += felt.rotational_A2 + felt.stiffness_factor * arm_A2;
    arms_A2 += arm_A2;
    pulls_A2 += pull_A2;
    if (felt.field) addField(*felt.field, lever, out);
    if (pull_A2 > farthest_A2) {
      farthest_A2 = pull_A2;
      out.contact.atoms = c.atoms;
      out.contact.feature = c.feature;
      out.contact.normals = c.normals;
    }
  }
  if (inside) {
    // The other atoms restart too, so that the whole body starts without force once it is outside.
    reset();
    held_ = 0;
    return {.contact = {.scp = pose.place, .fault = Fault::StartedInside}};
  }
  out.stiffness_factor = std::max(1.0, stiffness_factor);
  // In addition to the springs at the levers: rotating the levers also rotates the forces' torques (Cauchy-Schwarz
  // bound).
  out.rotational_A2 += std::sqrt(arms_A2 * pulls_A2);
  out.contact.scp.A += out.contact.displacement_A / out.stiffness_factor;
  return out;
}

std::size_t RigidBody::reactions(const Response&, double spring_N_per_A, double field_share,
                                 std::span<AtomForce> out) const noexcept {
  std::size_t count = 0;
  for (const Held& h : std::span(answers_).first(held_)) {
    const std::size_t first = count;
    count += spheres_[h.sphere]->reactions(h.answer, spring_N_per_A, field_share, out.subspan(count));
    for (std::size_t k = first; k < count; ++k) out[k].body_sphere = std::int32_t(h.sphere);
  }
  return count;
}

void RigidBody::reset() noexcept {
  for (const auto& sphere : spheres_) sphere->reset();
}

bool RigidBody::setMotion(const SphereMotion* motion) noexcept {
  // All spheres use the same method, so the first determines the result.
  for (const auto& sphere : spheres_)
    if (!sphere->setMotion(motion)) return false;
  return true;
}

void RigidBody::advanceTo(double fraction) noexcept {
  for (const auto& sphere : spheres_) sphere->advanceTo(fraction);
}

// The spheres mostly model the same atoms of the scene, which are counted once.
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
