#include "engine/lesson/tasks/held_way.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace moltact {

bool HeldWay::tick(const TouchSample& s, double dt_s) {
  const Contact& point = s.exact.fault == Fault::None && s.exact.touching() ? s.exact : s.contact;
  before_ = now_;
  now_ = s.body.value_or(PoseA{point.scp, kNoRotation});
  const bool was_there = std::exchange(there_, s.contact.fault == Fault::None && finite(now_.place.A));
  return there_ && was_there && !s.placed && dt_s > 0.0 && glm::distance(now_.place.A, before_.place.A) <= kJump_A &&
         glm::length(rotationBetween(before_.orientation, now_.orientation)) <= kJump_rad;
}

PoseGoal::PoseGoal(std::shared_ptr<const HeldBody> body, const PoseA& goal) : body_(std::move(body)), goal_(goal) {
  for (const Sphere& s : body_->spheres)
    spread_ += glm::outerProduct(s.centre_A, s.centre_A) / double(body_->spheres.size());
}

double PoseGoal::rmsd_A(const PoseA& pose) const {
  const glm::dmat3 off = glm::mat3_cast(pose.orientation) - glm::mat3_cast(goal_.orientation);
  const glm::dmat3 squares = off * spread_ * glm::transpose(off);
  const Vec3 d = pose.place.A - goal_.place.A;
  return std::sqrt(std::max(0.0, glm::dot(d, d) + squares[0][0] + squares[1][1] + squares[2][2]));
}

double PoseGoal::turned_rad(const PoseA& pose) const {
  return glm::length(rotationBetween(goal_.orientation, pose.orientation));
}

bool PoseGoal::stretched(const TouchSample& s, double within_A) const {
  return !s.one_spring && 2.0 * s.contact.energy_A2 > double(body_->spheres.size()) * within_A * within_A;
}

}  // namespace moltact
