#include "engine/bench/bodies/path_watch.h"

#include <algorithm>
#include <cmath>

#include "engine/bench/bodies/body_trade_off.h"

namespace moltact::bench {
namespace {

bool samePose(const PoseA& a, const PoseA& b) {
  return glm::distance(a.place.A, b.place.A) < 1e-9 &&
         glm::length(rotationBetween(a.orientation, b.orientation)) < 1e-9;
}

}  // namespace

PathWatch::PathWatch(std::vector<Sphere> scene, std::shared_ptr<const HeldBody> body, double through_A)
    : scene_(std::move(scene)), body_(std::move(body)), through_(through_A) {
  for (const Sphere& s : body_->spheres) reach_ = std::max(reach_, glm::length(s.centre_A));
}

void PathWatch::placed(const PoseA& at) noexcept {
  steps_.clear();
  been_.assign(1, at);
  at_ = at;
  begun_ = true;
  apart_ = false;
}

void PathWatch::moved(const PoseA& from, const PoseA& to, double fraction) noexcept {
  apart_ = apart_ || !begun_ || !samePose(from, at_);
  steps_.push_back({from, to, fraction});
  been_.push_back(to);
  at_ = to;
}

void PathWatch::returned(const PoseA& to) noexcept {
  apart_ = apart_ || std::none_of(been_.begin(), been_.end(), [&](const PoseA& p) { return samePose(p, to); });
  at_ = to;
}

bool PathWatch::tunnelled(const PoseA& now, const SphereMotion* motion) {
  bool out = apart_ || !begun_ || !samePose(now, at_);
  for (const Step& s : steps_) out = out || leadsThrough(s, motion);
  steps_.clear();
  been_.assign(1, at_);
  apart_ = false;
  return out;
}

bool PathWatch::leadsThrough(const Step& step, const SphereMotion* motion) const {
  const Vec3 way = step.to.place.A - step.from.place.A,
             turn = rotationBetween(step.from.orientation, step.to.orientation);
  const double angle = glm::length(turn);
  const int n = std::max(1, int(std::ceil((glm::length(way) + angle * reach_) / kStep_A)));
  const std::vector<Sphere> moving = motion ? motion->at(step.fraction) : std::vector<Sphere>();
  for (int k = 0; k <= n; ++k) {
    const double t = double(k) / n;
    const Quat by = angle > 0.0 ? glm::angleAxis(t * angle, turn / angle) : kNoRotation;
    const PoseA at{{step.from.place.A + t * way}, by * step.from.orientation};
    if (overlap_A(motion ? moving : scene_, *body_, at) > through_) return true;
  }
  return false;
}

}  // namespace moltact::bench
