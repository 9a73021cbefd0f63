#include "engine/haptics/body/exact_body.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace moltact {
namespace {

constexpr double kScenePiece_A = 0.02;  // largest motion of the scene's spheres before the body is moved out of them
constexpr double kMaxScenePieces = 64.0;

}  // namespace

ExactBody::ExactBody(std::shared_ptr<const SphereGrid> scene, std::shared_ptr<const HeldBody> body,
                     double rotational_A2)
    : scene_(std::move(scene)),
      body_(std::move(body)),
      pairs_(scene_, *body_),
      lever_(rotational_A2 > 0.0 ? std::sqrt(rotational_A2) : std::max(kMinLever_A, radiusOfGyration_A(*body_))) {}

void ExactBody::reset() noexcept {
  armed_ = false;
  at_rest_ = true;
  held_count_ = 0;
  free_room_ = rotation_ = first_rotation_ = 0.0;
  coupling_.reset();
  rows_known_ = metric_known_ = false;
}

bool ExactBody::setMotion(const SphereMotion* motion) noexcept {
  if (pairs_.has(motion)) return true;
  pairs_.setMotion(motion);
  goal_fraction_ = 0.0;
  moved_ = true;
  return true;
}

void ExactBody::advanceTo(double fraction) noexcept {
  if (!std::isfinite(fraction)) return;
  goal_fraction_ = std::clamp(fraction, 0.0, 1.0);
  moved_ = moved_ || goal_fraction_ != pairs_.fraction();
}

MemoryUsage ExactBody::memoryUsage() const noexcept {
  return {pairs_.farCount(), sizeof(*this) + pairs_.bytes() + scene_->bytes()};
}

// Moves the spheres to their state in this tick and the body out of them. Where that fails, the scene has closed over it.
void ExactBody::followScene() noexcept {
  moved_ = rows_known_ = metric_known_ = false;
  free_room_ = 0.0;
  const double from = pairs_.fraction();
  if (armed_) {
    pairs_.look(pose_);
    const double motion = std::abs(goal_fraction_ - from) * pairs_.maxMotion_A();
    // Each piece computes the listed spheres anew.
    const double most = std::clamp(double(pairs_.maxWork()) / double(1 + pairs_.farCount()), 1.0, kMaxScenePieces);
    const int pieces = int(std::clamp(std::ceil(motion / kScenePiece_A), 1.0, std::floor(most)));
    for (int k = 1; k <= pieces; ++k) {
      pairs_.advanceTo(k == pieces ? goal_fraction_ : from + (goal_fraction_ - from) * k / pieces);
      rows_known_ = false;
      if (restored()) continue;
      reset();
      break;
    }
  }
  pairs_.advanceTo(goal_fraction_);
}

// True if the body has a pose. At the start it takes the hand's, if that is free.
bool ExactBody::armed(const PoseA& pose) noexcept {
  if (armed_) return true;
  const BodyPose hand(pose.place.A - pairs_.origin(), pose.orientation);
  if (pairs_.overlaps(hand)) return false;
  reset();
  armed_ = true;
  coupling_.begin(pose);
  pose_ = hand;
  if (observer_) observer_->placed(inScene(pose_));
  return true;
}

Response ExactBody::respond(const PoseA& pose) noexcept {
  const auto refused = [&](Fault fault) {
    Response out;
    out.contact.fault = fault;
    out.contact.scp = finite(pose.place.A) ? pose.place : PointA{pairs_.origin() + pose_.place};
    return out;
  };
  if (!finite(pose.place.A) || !rotates(pose.orientation) ||
      glm::length(pose.place.A) > kMaxPosition_A - body_->reach_A)
    return refused(Fault::NotFinite);
  if (pairs_.exhausted()) rows_known_ = metric_known_ = false;  // the lists of the last tick go on
  pairs_.beginTick();
  work_from_ = pairs_.workCount();
  steps_ = changes_ = 0;
  max_changes_ = kMaxSceneChanges;
  if (moved_) followScene();
  if (!armed(pose)) return refused(Fault::StartedInside);
  hand_ = BodyPose(pose.place.A - pairs_.origin(),
                   coupling_.orientation(pose, pose_.orientation, held_count_ == 0, lever_));
  max_changes_ = changes_ + kMaxChanges;
  if (held_count_ == 0 && surfaceMotion_A(free_from_, hand_, pairs_.reach_A()) < free_room_) {
    go(hand_);
    at_rest_ = true;
  } else {
    seekRest();
  }
  return response(pose);
}

Response ExactBody::response(const PoseA& pose) const noexcept {
  Response out;
  out.at_rest = at_rest_;
  const bool with_hand = held_count_ == 0 && at_rest_;
  out.contact.scp = with_hand ? pose.place : PointA{pairs_.origin() + pose_.place};
  out.body_pose = PoseA{out.contact.scp, pose_.orientation};
  if (held_count_ == 0) return out;
  out.contact.displacement_A = pose_.place - hand_.place;
  const Vec3 theta = rotationBetween(pose_.orientation, hand_.orientation);
  out.torque_A2 = -lever_ * lever_ * theta;
  out.contact.energy_A2 = energyAt(pose_);
  out.rotational_A2 = lever_ * lever_;
  // The atoms with the largest multipliers, ascending.
  struct Share {
    std::int32_t atom;
    double lambda, largest;
    Vec3 normal;
  };
  std::array<Share, 6> shares{};
  std::size_t count = 0;
  for (int k = 0; k < held_count_; ++k) {
    const Held& h = held_[std::size_t(k)];
    std::size_t at = 0;
    while (at < count && shares[at].atom != h.atom) ++at;
    if (at == count) shares[count++] = {h.atom, 0.0, -1.0, Vec3(0.0)};
    shares[at].lambda += h.lambda;
    if (h.lambda > shares[at].largest) shares[at].largest = h.lambda, shares[at].normal = normals_[std::size_t(h.row)];
  }
  const std::size_t shown = std::min<std::size_t>(3, count);
  for (std::size_t k = 0; k < shown; ++k)
    for (std::size_t j = k + 1; j < count; ++j)
      if (shares[j].lambda > shares[k].lambda) std::swap(shares[j], shares[k]);
  for (std::size_t k = 0; k < shown; ++k)
    for (std::size_t j = k + 1; j < shown; ++j)
      if (shares[j].atom < shares[k].atom) std::swap(shares[j], shares[k]);
  for (std::size_t k = 0; k < shown; ++k) {
    out.contact.atoms[k] = shares[k].atom;
    out.contact.normals[k] = shares[k].normal;
  }
  out.contact.feature = shown == 1 ? Feature::Sphere : shown == 2 ? Feature::Circle : Feature::Point;
  return out;
}

std::size_t ExactBody::reactions(const Response& last, double spring_N_per_A, double,
                                 std::span<AtomForce> out) const noexcept {
  if (!last.contact.touching()) return 0;
  Vec3 rest = last.contact.displacement_A;
  double sum = 0.0;
  const auto count = std::size_t(held_count_);
  for (std::size_t k = 0; k < count; ++k) {
    rest -= normals_[std::size_t(held_[k].row)] * held_[k].lambda;
    sum += held_[k].lambda;
  }
  for (std::size_t k = 0; k < count; ++k) {
    const double part = sum > 0.0 ? held_[k].lambda / sum : 1.0 / double(count);
    out[k] = {held_[k].atom, -spring_N_per_A * (normals_[std::size_t(held_[k].row)] * held_[k].lambda + rest * part),
              pairs_.indexInBody(held_[k].sphere)};
  }
  return count;
}

}  // namespace moltact
