#include "engine/lesson/tasks/held_way.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/core/random.h"
#include "engine/lesson/pose_text.h"

namespace moltact {

bool HeldWay::tick(const TouchSample& s, double dt_s) {
  const Contact& point = s.exact.fault == Fault::None && s.exact.touching() ? s.exact : s.contact;
  before_ = now_;
  now_ = s.body.value_or(PoseA{point.scp, kNoRotation});
  const bool was_there = std::exchange(there_, s.contact.fault == Fault::None && finite(now_.place.A));
  return there_ && was_there && !s.contact_reset && dt_s > 0.0 &&
         glm::distance(now_.place.A, before_.place.A) <= kJump_A &&
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

PoseA writtenGoal(std::string_view text, const HeldBody& body) {
  const auto written = parsePose(text);
  return written ? PoseA{written->place, written->orientation.value_or(kNoRotation)} : PoseA{body.middle, kNoRotation};
}

std::optional<PoseA> freePoseAt(const PoseGoal& goal, const PoseTolerance& tolerance, const PoseSpace& space,
                                std::uint64_t seed) {
  constexpr int kNear = 4000;    // poses that are tried
  constexpr double kPart = 0.6;  // of what is allowed, at most, off the goal
  if (seed == 0 && space.isFree(goal.goal())) return goal.goal();
  std::uint64_t random = seed + 1;
  for (int k = 0; k < kNear; ++k) {
    const double size = kPart * tolerance.within_A * (k + 1) / kNear;
    const auto any = [&] { return Vec3(nextFraction(random), nextFraction(random), nextFraction(random)) * 2.0 - 1.0; };
    PoseA pose = goal.goal();
    pose.place.A += any() * size;
    const Vec3 turn = any() * (size / space.gyration_A());
    pose.orientation = glm::normalize(glm::angleAxis(glm::length(turn), glm::normalize(turn)) * pose.orientation);
    if (tolerance.allows(goal, pose, kPart) && space.isFree(pose)) return pose;
  }
  return std::nullopt;
}

std::vector<Well> wellsBeside(const PoseGoal& goal, const PoseTolerance& tolerance, const SceneForces& forces,
                              int falls) {
  const PoseSpace space(forces.spheres(), goal.body());
  std::vector<Well> out;
  for (int k = 0; k < falls; ++k) {
    const auto start = freePoseAt(goal, tolerance, space, std::uint64_t(k));
    if (!start) break;
    std::optional<Well> last;
    forces.fall(*start, {}, [&](const Well& now) {
      if (!tolerance.allows(goal, now.pose)) return false;
      last = now;
      return true;
    });
    if (last) out.push_back(*last);
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const Well& a, const Well& b) { return a.energy.total_kcal_mol() < b.energy.total_kcal_mol(); });
  return out;
}

double searchReach_A(const SphereGrid& spheres, const HeldBody& body) {
  constexpr double kMaxReach_A = 40.0;
  return std::min(kMaxReach_A, 0.5 * glm::distance(spheres.low_A(), spheres.high_A()) + body.reach_A);
}

HandPlan planAlong(const std::vector<PoseA>& way, double share, double wait_s) {
  constexpr double kOutside_A_per_s = 30.0, kInside_A_per_s = 5.0;
  HandPlan plan{{.to = way.front().place, .placed = true, .wait_s = 0.3}};
  if (share >= 0.0) plan.push_back({.share = share});
  plan.push_back({.turned_to = way.front().orientation});
  for (std::size_t k = 1; k < way.size(); ++k)
    plan.push_back({.to = way[k].place,
                    .speed_A_per_s = k == 1 ? kOutside_A_per_s : kInside_A_per_s,
                    .turned_to = way[k].orientation});
  plan.back().wait_s = wait_s;
  return plan;
}

}  // namespace moltact
