// The search of the exact body for its rest pose (docs/exact-body.md). Part of ExactBody; haptic thread. Each step leaves
// a pose without overlap, and its path is free of overlap too.
#include <algorithm>
#include <cmath>

#include "engine/haptics/body/exact_body.h"

namespace moltact {
namespace {

constexpr double kStep_A = 0.4;      // largest motion of a sphere in a step
constexpr double kRest = 1e-11;      // residual of the force balance at rest, relative to the force (at least 1 A)
constexpr double kRestGap_A = 1e-9;  // largest gap of a contact that carries force
constexpr double kSmall_A = 1e-6;    // steps below this change the energy by less than rounding
constexpr double kSaddle = -1e-7;    // curvature of a saddle
constexpr std::array<double, 4> kKicks_A{1e-2, 1e-3, 1e-2,
                                         1e-3};  // steps off a saddle, the next where one gains nothing
constexpr int kClosing = 2;                      // last steps of a tick, which close the gaps that Newton's steps leave
constexpr double kSink_A = 1e-7;                 // a squeezed body's path may sink this far between two free poses
constexpr double kNextRotation = 0.2;  // bound of the next rotation relative to the last, which converges faster
constexpr double kMargin = 1.4,
                 kMaxGrowth = 2.5;  // of the bound of the next rotation while the rotations do not shrink
constexpr double kMinRotation = 1e-13;
constexpr double kMinRoom_A = 1e-3;  // with less, a body whose next list is not complete waits for the next tick

}  // namespace

// Takes the active set of a program. `part`: the share of the pull for which it was solved.
void ExactBody::hold(const QpSolution& solution, double part) noexcept {
  const std::span<const BodyPair> near = pairs_.near();
  held_count_ = 0;
  for (int k = 0; k < solution.count; ++k) {
    const int row = solution.rows[std::size_t(k)];
    const BodyPair& pair = near[std::size_t(row)];
    held_[std::size_t(held_count_++)] = {pair.sphere, pair.atom, solution.lambda[std::size_t(k)] / part, row};
  }
}

void ExactBody::go(const BodyPose& to) noexcept {
  if (observer_) observer_->moved(inScene(pose_), inScene(to), pairs_.fraction());
  pose_ = to;
  rows_known_ = metric_known_ = false;
}

void ExactBody::returnTo(const Saved& to) noexcept {
  if (observer_) observer_->returned(inScene(to.pose));
  pose_ = to.pose;
  rows_known_ = metric_known_ = false;
  held_ = to.held;
  held_count_ = to.held_count;
}

// True if forces and torques balance and every contact that carries force is closed.
bool ExactBody::converged(const Six& pull) const noexcept {
  Six rest = pull;
  for (int k = 0; k < held_count_; ++k) {
    const Held& held = held_[std::size_t(k)];
    rest.add(held.lambda, rows_[std::size_t(held.row)]);
    if (held.lambda > 0.0 && gaps_[std::size_t(held.row)] - kSkin_A > kRestGap_A) return false;
  }
  return length(rest) <= kRest * std::max(1.0, length(pull));
}

void ExactBody::seekRest() noexcept {
  const Saved before = saved();
  const double energy_before = energyAt(pose_);
  std::size_t kicks = 0;
  double saddle_energy = 0.0;
  Saved saddle;
  at_rest_ = false;
  rotation_ = std::max(first_rotation_, kMinRotation);
  part_ = 1.0;
  while (steps_ < kMaxSteps && changes_ < max_changes_) {
    lookAround();
    if (pairs_.exhausted() && room_ < kMinRoom_A) break;
    const Six d = pull();
    if (converged(d)) {
      const double energy = energyAt(pose_);
      if (held_count_ == 0) {
        if (observer_) observer_->moved(inScene(pose_), inScene(hand_), pairs_.fraction());
        pose_ = hand_;
        at_rest_ = true;
        break;
      }
      const bool gained_nothing = kicks > 0 && energy >= saddle_energy - 1e-12 * (1.0 + energy);
      if (gained_nothing) {
        returnTo(saddle);
        if (kicks % 2 == 0) {  // no saddle, but one of several choices of multipliers
          at_rest_ = true;
          break;
        }
        lookAround();
      }
      lookAtMetric(d);
      Six direction;
      at_rest_ = metric_.definite || smallestCurvature(d, direction) >= kSaddle;
      if (at_rest_ || kicks == kKicks_A.size()) break;
      if (!gained_nothing) {
        kicks += kicks % 2;
        if (kicks == kKicks_A.size()) break;
        saddle = saved();
        saddle_energy = energy;
      }
      ++steps_;
      at_rest_ = !kicked(direction, kKicks_A[kicks++]);
      if (at_rest_) break;
      continue;
    }
    ++steps_;
    if (!advance(d)) break;
  }
  lookAround();
  // A tick that was cut short behind a kick or while hovering must not end with more energy than it began with.
  if (energyAt(pose_) > energy_before + 1e-12 * (1.0 + energy_before)) {
    returnTo(before);
    lookAround();
    at_rest_ = false;
  }
  if (held_count_ == 0 && at_rest_) {
    double least = room_;
    for (std::size_t k = 0; k < row_count_; ++k) least = std::min(least, gaps_[k]);
    free_room_ = least - 2.0 * kSkin_A;
    free_from_ = pose_;
  } else {
    free_room_ = 0.0;
  }
}

// A small step off a saddle along its direction, to the side where there is more room.
bool ExactBody::kicked(const Six& direction, double by_A) noexcept {
  QpSolution best;
  double most = 0.0;
  for (const double sign : {1.0, -1.0}) {
    Six toward = direction;
    toward.scale(sign * by_A);
    if (!regulated(nullptr, toward)) continue;
    const double along = sign * dot(solution_.step, direction);
    if (along > most) most = along, best = solution_;
  }
  if (!(most > 0.01 * by_A)) return false;
  const BodyPose to = moved(best.step);
  rotation_ = std::max(kMinRotation, glm::length(best.step.rotation()) / lever_);
  go(to);
  return true;
}

// One step of the search. False if nothing moves.
bool ExactBody::advance(const Six& pull) noexcept {
  const bool closes = steps_ > kMaxSteps - kClosing;
  if (!closes) lookAtMetric(pull);
  bool found = regulated(closes ? nullptr : &metric_, pull);
  if (!closes && found && !accepted(pull)) found = regulated(nullptr, pull);
  if (!found) return squeezed(pull);
  const double turned = glm::length(solution_.step.rotation()) / lever_;
  if (steps_ == 1) first_rotation_ = kMargin * turned;
  const double grows = steps_ > 1 && last_turned_ > 0.0 ? turned / last_turned_ : 0.0;
  last_turned_ = turned;
  rotation_ = std::max((grows > 0.5 ? std::min(kMargin * grows, kMaxGrowth) : kNextRotation) * turned, kMinRotation);
  const BodyPose to = moved(solution_.step);
  hold(solution_, part_);
  go(to);
  return true;
}

// Solves for a step that is short enough for the list of pairs and turns by less than the constraints allow for. Leaves
// it in solution_; false if there is none.
bool ExactBody::regulated(const Factor6* metric, Six pull) noexcept {
  const double cap = row_count_ == 0 ? std::max(room_, 0.0) : std::min(kStep_A, std::max(room_, 0.0));
  int shrunk = 0;
  // After a step that was cut to the cap, the next begins with a similar share of the pull.
  part_ = metric ? std::min(1.0, kMargin * part_) : 1.0;
  pull.scale(part_);
  for (int tries = 0; tries < 16 && changes_ < max_changes_; ++tries) {
    solution_ = solve(metric, pull, rotation_);
    if (!solution_.feasible) {
      if (++shrunk > 5) return false;
      pull.scale(0.25);
      part_ *= 0.25;
      rotation_ *= 0.25;
      continue;
    }
    double turned = glm::length(solution_.step.rotation()) / lever_;
    const double motion = motion_A(solution_.step);
    if (motion > cap) {
      const double part = 0.95 * cap / motion;
      pull.scale(part);
      part_ *= part;
      turned *= part;
      if (turned > rotation_) rotation_ = kMargin * turned;
      continue;
    }
    if (part_ < 1.0 && shrunk == 0 && motion < 0.4 * cap) {
      const double more = std::min(1.0 / part_, 0.8 * cap / std::max(motion, 1e-12));
      pull.scale(more);
      part_ *= more;
      continue;
    }
    if (turned <= rotation_) return true;
    rotation_ = kMargin * turned;
  }
  return false;
}

// True if the step lowers the Lagrangian: a step along a sphere ends above it, which a later step makes up for.
bool ExactBody::accepted(const Six& pull) const noexcept {
  if (motion_A(solution_.step) < kSmall_A) return true;
  const BodyPose to = moved(solution_.step);
  double merit = energyAt(to);
  const std::span<const BodyPair> near = pairs_.near();
  for (int k = 0; k < solution_.count; ++k) {
    const BodyPair& pair = near[std::size_t(solution_.rows[std::size_t(k)])];
    const Vec3 c = to.place + to.axes * pairs_.spheres()[std::size_t(pair.sphere)].centre_A;
    merit -= solution_.lambda[std::size_t(k)] * std::max(0.0, glm::distance(c, pair.centre) - pair.radii - kSkin_A);
  }
  const double energy = 0.5 * dot(pull, pull);
  return merit <= energy + 1e-13 * (1.0 + energy);
}

// A step where the surroundings leave no room for the second-order term of a rotation. It omits that term, is so short
// that the path sinks by less than kSink_A, and is followed by a restoration of the gaps.
bool ExactBody::squeezed(const Six& pull) noexcept {
  solution_ = solve(nullptr, pull, 0.0);
  if (!solution_.feasible) return false;
  const double turned = glm::length(solution_.step.rotation()) / lever_, motion = motion_A(solution_.step);
  double part = motion > 0.0 ? std::min(1.0, 0.95 * std::min(kStep_A, std::max(room_, 0.0)) / motion) : 1.0;
  if (turned > 0.0) part = std::min(part, std::sqrt(kSink_A / std::max(pairs_.reach_A(), 1e-3)) / turned);
  hold(solution_, 1.0);
  rotation_ = kMinRotation;
  const Saved here = saved();
  go(moved(solution_.step, part));
  const double energy = 0.5 * dot(pull, pull);
  if (restored() && energyAt(pose_) <= energy + 1e-13 * (1.0 + energy)) return true;
  returnTo(here);
  return false;
}

// Moves the body by the least way out of the spheres that it overlaps; false if there is none.
bool ExactBody::restored() noexcept {
  constexpr int kMaxRestorations = 20;
  double turned = 0.0;
  for (int k = 0; k < kMaxRestorations; ++k) {
    lookAround();
    double least = kSkin_A;
    for (std::size_t r = 0; r < row_count_; ++r) least = std::min(least, gaps_[r]);
    if (least >= 0.5 * kSkin_A) return true;
    const double sink = 0.5 * turned * turned * pairs_.reach_A();
    for (std::size_t r = 0; r < row_count_; ++r) bounds_[r] = kSkin_A - gaps_[r] + (gaps_[r] < 0.1 ? sink : 0.0);
    const QpSolution out = program(nullptr, {}, {});
    if (!out.feasible) {
      if (turned == 0.0) return false;
      turned = 0.0;
      continue;
    }
    const double motion = motion_A(out.step), cap = std::min(kStep_A, std::max(room_, 0.0));
    const double part = motion > cap ? 0.95 * cap / motion : 1.0;
    if (!(motion > 0.0) || !(part > 0.0)) return false;
    turned = std::min(0.1 * glm::length(out.step.rotation()) / lever_, 1e-3);
    go(moved(out.step, part));
  }
  return false;
}

}  // namespace moltact
