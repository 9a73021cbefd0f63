#include "engine/bench/methods/point_penalty.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace moltact::bench {
namespace {

constexpr double kMinLever_A = 0.5;
constexpr double kBalanced = 1e-11;  // length of a step at which the body is at rest
constexpr int kMaxHalvings = 12;

BodyPose moved(const BodyPose& from, const Six& step, double lever_A) {
  const Vec3 turn = step.rotation() / lever_A;
  const double angle = glm::length(turn);
  const Quat by = angle > 0.0 ? glm::angleAxis(angle, turn / angle) : kNoRotation;
  return {from.place + step.translation(), by * from.orientation};
}

}  // namespace

PointPenalty::PointPenalty(std::shared_ptr<const SphereGrid> scene, std::shared_ptr<const HeldBody> body,
                           double rotational_A2)
    : scene_(std::move(scene)),
      body_(std::move(body)),
      pairs_(scene_, *body_),
      lever_(rotational_A2 > 0.0 ? std::sqrt(rotational_A2) : std::max(kMinLever_A, radiusOfGyration_A(*body_))) {}

void PointPenalty::reset() noexcept {
  armed_ = false;
  free_room_ = 0.0;
}

bool PointPenalty::setMotion(const SphereMotion* motion) noexcept {
  if (pairs_.has(motion)) return true;
  pairs_.setMotion(motion);
  free_room_ = 0.0;
  return true;
}

void PointPenalty::advanceTo(double fraction) noexcept {
  if (!std::isfinite(fraction)) return;
  pairs_.advanceTo(std::clamp(fraction, 0.0, 1.0));
  free_room_ = 0.0;
}

MemoryUsage PointPenalty::memoryUsage() const noexcept {
  return {pairs_.farCount(), sizeof(*this) + pairs_.bytes() + scene_->bytes()};
}

Response PointPenalty::refused(const PoseA& pose, Fault fault) const noexcept {
  Response out;
  out.contact.fault = fault;
  out.contact.scp = finite(pose.place.A) ? pose.place : PointA{pairs_.origin() + pose_.place};
  return out;
}

PointPenalty::Balance PointPenalty::balanceAt(const BodyPose& at, const BodyPose& hand) noexcept {
  pairs_.look(at);
  Balance out;
  deepest_.fill({});
  out.pull = Six(hand.place - at.place, lever_ * rotationBetween(at.orientation, hand.orientation));
  out.energy = 0.5 * dot(out.pull, out.pull);
  for (std::size_t i = 0; i < 6; ++i) out.curvature.row[i][i] = 1.0;
  const auto spheres = pairs_.spheres();
  for (const BodyPair& pair : pairs_.near()) {
    const Vec3 arm = at.axes * spheres[std::size_t(pair.sphere)].centre_A, m = at.place + arm - pair.centre;
    const double d2 = glm::dot(m, m);
    if (d2 >= pair.radii * pair.radii) {
      out.least_gap = std::min(out.least_gap, std::sqrt(d2) - pair.radii);
      continue;
    }
    const double d = std::sqrt(d2), depth = pair.radii - d, push = kContact * depth;
    if (!(d > 0.0)) continue;  // no direction is preferred
    const Vec3 n = m / d;
    const Six row(n, glm::cross(arm, n) / lever_);
    ++out.touching;
    out.energy += 0.5 * kContact * depth * depth;
    out.pull.add(push, row);
    // The second derivative of depth^2 / 2: N N^T less depth times that of the gap.
    out.curvature.addOuter(kContact + push / d, row);
    for (int axis = 0; axis < 3; ++axis) {
      Vec3 e(0.0);
      e[axis] = 1.0;
      out.curvature.addOuter(-push / d, Six(e, glm::cross(arm, e) / lever_));
    }
    const double na = glm::dot(n, arm), per_L2 = 1.0 / (lever_ * lever_);
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j <= i; ++j)
        out.curvature.row[std::size_t(3 + i)][std::size_t(3 + j)] -=
            push * per_L2 * (0.5 * (n[i] * arm[j] + n[j] * arm[i]) - (i == j ? na : 0.0));
    Push next{depth, pair.atom, n};
    for (Push& kept : deepest_)
      if (next.depth > kept.depth) std::swap(kept, next);
  }
  return out;
}

double PointPenalty::energyFor_A2(const PoseA& hand) noexcept { return balanceAt(pose_, relative(hand)).energy; }

Response PointPenalty::respond(const PoseA& pose) noexcept {
  if (!finite(pose.place.A) || !rotates(pose.orientation) ||
      glm::length(pose.place.A) > kMaxPosition_A - body_->reach_A)
    return refused(pose, Fault::NotFinite);
  const BodyPose hand = relative(pose);
  if (!armed_) {
    if (pairs_.overlaps(hand)) return refused(pose, Fault::StartedInside);
    armed_ = true;
    pose_ = hand;
    free_room_ = 0.0;
  }
  Response out;
  out.contact.scp = pose.place;
  out.body_pose = PoseA{pose.place, hand.orientation};
  if (surfaceMotion_A(free_from_, hand, pairs_.reach_A()) < free_room_) {
    pose_ = hand;
    return out;
  }
  free_room_ = 0.0;

  Balance now = balanceAt(pose_, hand);
  bool converged = false;
  for (int k = 0; k < kMaxSteps && !converged; ++k) {
    const Factor6 factor = factored(now.curvature, 1e-3, 0.05);
    Six step = factor.backward(factor.forward(now.pull));
    converged = length(step) < kBalanced;
    if (converged) break;
    bool lower = false;
    for (int half = 0; half < kMaxHalvings && !lower; ++half) {
      const BodyPose to = moved(pose_, step, lever_);
      const Balance there = balanceAt(to, hand);
      lower = there.energy < now.energy;
      if (lower) pose_ = to, now = there;
      step.scale(0.5);
    }
    converged = !lower;  // no step of this size changes the energy any more: rounding
    if (converged) now = balanceAt(pose_, hand);
  }
  out.at_rest = converged;
  if (now.touching == 0 && converged) {
    pose_ = hand;
    free_from_ = hand;
    free_room_ = std::min(now.least_gap, pairs_.covered_A(hand));
    return out;
  }
  out.contact.scp.A = pairs_.origin() + pose_.place;
  out.body_pose = PoseA{out.contact.scp, pose_.orientation};
  if (now.touching == 0) return out;
  out.contact.displacement_A = pose_.place - hand.place;
  const Vec3 theta = rotationBetween(pose_.orientation, hand.orientation);
  out.torque_A2 = -lever_ * lever_ * theta;
  out.contact.energy_A2 = now.energy;
  out.rotational_A2 = lever_ * lever_;
  out.contact.feature = Feature(std::min(now.touching, 3));
  for (std::size_t k = 0; k < deepest_.size(); ++k) {
    out.contact.atoms[k] = deepest_[k].atom;
    out.contact.normals[k] = deepest_[k].normal;
  }
  return out;
}

}  // namespace moltact::bench
