#include "engine/haptics/friction.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace moltact {
namespace {

// How often a call asks the interaction inside. A slip moves the contact, which turns its normal and changes its normal
// force; the drag follows by iteration. What a body leaves over follows in the next tick.
constexpr int kMaxAsked = 24, kMaxAskedOfBody = 4;
constexpr double kShareRounding = 1e-10;  // of the load at which a slip ends, and of an energy
constexpr double kRounding_A = 1e-9;
// A pull that the contact's normals do not explain to this share is that of a method that shades or sums springs.
constexpr double kExplained = 1e-6;

}  // namespace

FrictionLayer::FrictionLayer(std::unique_ptr<Interaction> inner, std::shared_ptr<const SphereGrid> scene,
                             std::shared_ptr<const HeldBody> body, std::shared_ptr<const Roughness> roughness,
                             const Friction& friction)
    : WrappedInteraction(std::move(inner)),
      scene_(std::move(scene)),
      body_(std::move(body)),
      roughness_(std::move(roughness)),
      anchors_(maxReactionCount()),
      room_(maxReactionCount()) {
  setFriction(friction);
}

void FrictionLayer::setFriction(const Friction& friction) noexcept {
  if (std::isfinite(friction.coefficient)) friction_.coefficient = std::clamp(friction.coefficient, 0.0, kMaxFriction);
  if (std::isfinite(friction.stick_slip)) friction_.stick_slip = std::clamp(friction.stick_slip, 0.0, 1.0);
}

void FrictionLayer::setSurface(const SurfaceProperties& surface) noexcept {
  inner().setSurface(surface);
  setFriction(surface.friction);
}

SurfaceProperties FrictionLayer::surface() const noexcept {
  SurfaceProperties out = inner().surface();
  out.friction = friction_;
  return out;
}

void FrictionLayer::reset() noexcept {
  touching_ = slipped_ = false;
  inner().reset();
}

bool FrictionLayer::setMotion(const SphereMotion* motion) noexcept {
  if (!inner().setMotion(motion)) return false;
  const std::uint64_t serial = motion ? motion->serial() : 0;
  if (motion == motion_ && serial == motion_serial_) return true;
  motion_ = motion;
  motion_serial_ = serial;
  fraction_ = 0.0;
  surface_moved_ = true;
  return true;
}

void FrictionLayer::advanceTo(double fraction) noexcept {
  inner().advanceTo(fraction);
  fraction_ = fraction;
  surface_moved_ = true;
}

void FrictionLayer::setProbe(double probe_A) noexcept {
  inner().setProbe(probe_A);
  surface_moved_ = true;
}

MemoryUsage FrictionLayer::memoryUsage() const noexcept {
  MemoryUsage out = inner().memoryUsage();
  out.bytes += roughness_ ? roughness_->capacity() * sizeof(float) : 0;
  return out;
}

Vec3 FrictionLayer::centre_A(std::int32_t atom) const noexcept {
  const auto i = std::size_t(atom);
  return motion_ ? (*motion_)[i].at(fraction_).centre_A : (*scene_)[i].centre_A;
}

double FrictionLayer::roughnessOf(std::int32_t atom) const noexcept {
  return roughness_ && std::size_t(atom) < roughness_->size() ? double((*roughness_)[std::size_t(atom)]) : 1.0;
}

// Asks the interaction inside and keeps what the next call depends on.
const Response& FrictionLayer::ask(const PoseA& held) noexcept {
  if (!touching_) share_ = 1.0;
  held_ = held;
  inner_answer_ = inner().respond(held);
  touching_ = inner_answer_.contact.touching() && inner_answer_.springsPull();
  grip_A_ = grip_turn_A2_ = 0.0;
  anchor_count_ = 0;
  if (!touching_) return inner_answer_;
  const std::size_t count = inner().reactions(inner_answer_, 1.0, 0.0, room_);
  const Quat& turned = inner_answer_.shownBody(held).orientation;
  double sum = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    const AtomForce& push = room_[k];
    const double normal = glm::length(push.force_N);
    if (push.atom < 0 || std::size_t(push.atom) >= scene_->size() || !(normal > 0.0)) continue;
    const double grip = normal * roughnessOf(push.atom);
    grip_A_ += grip;
    if (body_ && push.body_sphere >= 0)
      grip_turn_A2_ += grip * glm::length(turned * body_->spheres[std::size_t(push.body_sphere)].centre_A);
    anchors_[anchor_count_++] = {push.atom, normal, centre_A(push.atom)};
    sum += normal;
  }
  for (std::size_t k = 0; k < anchor_count_; ++k) anchors_[k].share /= sum;
  if (anchor_count_ == 0) grip_A_ = glm::length(inner_answer_.contact.displacement_A);  // a surface without atoms
  return inner_answer_;
}

// Moves the held-back hand with the atoms that are touched.
void FrictionLayer::carry() noexcept {
  Vec3 moved(0.0);
  for (std::size_t k = 0; k < anchor_count_; ++k)
    moved += anchors_[k].share * (centre_A(anchors_[k].atom) - anchors_[k].centre_A);
  held_.place.A += moved;
}

// Splits the force of the hand's spring: the contacts' normals bear what they can, friction bears the remainder.
FrictionLayer::Lag FrictionLayer::lagBehind(const PoseA& hand) const noexcept {
  const Contact& contact = inner_answer_.contact;
  const Vec3& pressed = contact.displacement_A;
  Lag out{held_.place.A - hand.place.A};
  if (!body_ && glm::length(pushesAlong(contact, pressed).rest) <= kExplained * glm::length(pressed)) {
    const Pushes pushes = pushesAlong(contact, pressed + out.way_A);
    out.way_A = pushes.rest;
    for (std::size_t k = 0; k < 3; ++k)
      if (contact.atoms[k] >= 0) out.grip_A += pushes.along[k] * roughnessOf(contact.atoms[k]);
    return out;
  }
  // The normals of many contacts count as one direction. Translation and rotation are one vector of six; its length is
  // that of the energy.
  const double lever2 = inner_answer_.body_pose ? inner_answer_.rotational_A2 : 0.0;
  Vec3 twisted(0.0);
  if (lever2 > 0.0) {
    out.turn_rad = rotationBetween(hand.orientation, held_.orientation);
    twisted = inner_answer_.torque_A2 / lever2;
  }
  const double p2 = glm::dot(pressed, pressed) + lever2 * glm::dot(twisted, twisted);
  if (!(p2 > 0.0)) return out;
  const double more = (glm::dot(pressed, out.way_A) + lever2 * glm::dot(twisted, out.turn_rad)) / p2;
  out.way_A -= more * pressed;
  out.turn_rad -= more * twisted;
  out.grip_A = std::max(0.0, 1.0 + more) * grip_A_;
  out.grip_turn_A2 = std::max(0.0, 1.0 + more) * grip_turn_A2_;
  return out;
}

// Drag and torque as a share of those of sliding: 1 on the ellipsoid that bounds them.
double FrictionLayer::load(const Lag& lag) const noexcept {
  const auto share = [&](double is, double grip) {
    const double most = friction_.coefficient * grip;
    return is > 0.0 ? (most > 0.0 ? is / most : 1e300) : 0.0;
  };
  return std::min(1e300, std::hypot(share(glm::length(lag.way_A), lag.grip_A),
                                    share(inner_answer_.rotational_A2 * glm::length(lag.turn_rad), lag.grip_turn_A2)));
}

Response FrictionLayer::respond(const PoseA& pose) noexcept {
  slipped_ = false;
  if (friction_.coefficient <= 0.0) {
    touching_ = false;
    return inner().respond(pose);
  }
  const bool moved = std::exchange(surface_moved_, false);
  if (!touching_ || !finite(pose.place.A) || !rotates(pose.orientation)) return ask(pose);
  carry();
  Lag lag = lagBehind(pose);
  double now = load(lag), most = 1.0 + friction_.stick_slip;
  const double stayed_A2 = answer(pose).contact.energy_A2;
  for (int k = 0; k < (body_ ? kMaxAskedOfBody : kMaxAsked); ++k) {
    const bool slips = now > most * (1.0 + kShareRounding);
    if (k > 0 && !slips) break;
    if (slips) {
      slipped_ = true;
      lag.way_A /= now;
      lag.turn_rad /= now;
      most = 1.0;
    }
    PoseA held{{pose.place.A + lag.way_A}, pose.orientation};
    if (const double angle = glm::length(lag.turn_rad); angle > 0.0)
      held.orientation = glm::normalize(glm::angleAxis(angle, lag.turn_rad / angle) * pose.orientation);
    ask(held);
    if (inner_answer_.contact.fault != Fault::None) return inner_answer_;
    if (!touching_) {
      share_ = 1.0;
      return held.place == pose.place && held.orientation == pose.orientation ? inner_answer_ : ask(pose);
    }
    lag = lagBehind(pose);
    now = load(lag);
  }
  account(stayed_A2, pose, moved);
  return answer(pose);
}

// A slip over a ridge can lead to where the spring is longer than before. It is then felt softer, by as much as keeps
// the energy, until later slips have taken that much. Energy that comes from a moving surface is not a slip's.
void FrictionLayer::account(double stayed_A2, const PoseA& pose, bool surface_moved) noexcept {
  const Contact& contact = inner_answer_.contact;
  const bool spring_to_scp =
      inner_answer_.body_pose || glm::distance(contact.displacement_A, contact.scp.A - held_.place.A) < kRounding_A;
  if (!spring_to_scp || surface_moved) return;
  const double before = std::exchange(share_, 1.0), whole_A2 = answer(pose).contact.energy_A2;
  if (stayed_A2 < whole_A2 * (1.0 - kShareRounding)) share_ = stayed_A2 / whole_A2;
  if (!slipped_) share_ = std::min(share_, before);
}

// The springs from the hand to where the interaction inside rests.
Response FrictionLayer::answer(const PoseA& hand) const noexcept {
  Response out = inner_answer_;
  const Vec3 way = held_.place.A - hand.place.A;
  out.contact.energy_A2 += glm::dot(way, out.contact.displacement_A) + 0.5 * glm::dot(way, way);
  out.contact.displacement_A += way;
  if (const double lever2 = out.rotational_A2; out.body_pose && lever2 > 0.0) {
    const auto rotation = [](const Vec3& turn) {
      const double angle = glm::length(turn);
      return angle > 0.0 ? glm::angleAxis(angle, turn / angle) : kNoRotation;
    };
    const Vec3 held = out.torque_A2 / lever2, lag = rotationBetween(hand.orientation, held_.orientation);
    const Vec3 all = rotationBetween(kNoRotation, rotation(held) * rotation(lag));
    out.contact.energy_A2 += 0.5 * lever2 * (glm::dot(all, all) - glm::dot(held, held));
    out.torque_A2 = lever2 * all;
  }
  if (share_ != 1.0) {
    out.contact.displacement_A *= share_;
    out.contact.energy_A2 *= share_;
    out.torque_A2 *= share_;
  }
  return out;
}

std::size_t FrictionLayer::reactions(const Response& last, double spring_N_per_A, double field_share,
                                     std::span<AtomForce> out) const noexcept {
  if (!touching_) return inner().reactions(last, spring_N_per_A, field_share, out);
  const std::size_t count = inner().reactions(inner_answer_, spring_N_per_A, field_share, out);
  for (std::size_t k = 0; k < count; ++k) out[k].force_N *= share_;
  // The drag acts on the atoms in proportion to their normal forces.
  Vec3 drag = -last.total(spring_N_per_A, field_share).force_N;
  double sizes = 0.0;
  for (std::size_t k = 0; k < count; ++k) drag -= out[k].force_N, sizes += glm::length(out[k].force_N);
  if (sizes > 0.0)
    for (std::size_t k = 0; k < count; ++k) out[k].force_N += drag * (glm::length(out[k].force_N) / sizes);
  return count;
}

}  // namespace moltact
