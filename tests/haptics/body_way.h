// Judges the way of an exact body between its ticks with the oracle over all pairs: every place of every step. A path is
// followed by bisection. The gap changes by at most the motion of the body's surface, so between two places with the
// gaps g and h that are a motion m apart it is at least (g + h - m) / 2. Units: angstrom.
#pragma once

#include <doctest/doctest.h>

#include <algorithm>
#include <memory>
#include <vector>

#include "engine/bench/bodies/body_oracle.h"
#include "engine/haptics/body/exact_body.h"
#include "engine/haptics/sphere_motion.h"

namespace moltact::test {

class BodyWay final : public BodyPathObserver {
 public:
  using Oracle = oracle::BodyOracle;
  static constexpr double kCertain_A = 1e-3;  // no place of a path may be known only to overlap by less

  BodyWay(std::vector<Sphere> scene, std::shared_ptr<const HeldBody> body)
      : body_(std::move(body)), standing_(scene, body_->spheres, 1.0) {
    for (const Sphere& s : body_->spheres) reach_ = std::max(reach_, glm::length(s.centre_A));
  }

  void placed(const PoseA& at) noexcept override { steps_.push_back({Kind::Placed, at, at, 0.0}); }
  void moved(const PoseA& from, const PoseA& to, double fraction) noexcept override {
    steps_.push_back({Kind::Moved, from, to, fraction});
  }
  void returned(const PoseA& to) noexcept override { steps_.push_back({Kind::Returned, to, to, 0.0}); }

  /// After a tick: judges its steps. `motion` is that of the spheres; null: they stand still.
  void judge(const Response& response, const SphereMotion* motion = nullptr) {
    std::vector<PoseA> been{now_};
    for (const Step& s : steps_) {
      if (s.kind == Kind::Placed) {
        been.clear();
      } else if (s.kind == Kind::Moved) {
        // Each step begins where the one before has ended.
        broken += !begun_ || !same(s.from, now_);
        follow(s, motion);
        ++count;
      } else {
        broken += std::none_of(been.begin(), been.end(), [&](const PoseA& p) { return same(p, s.to); });
      }
      now_ = s.to;
      begun_ = true;
      been.push_back(now_);
    }
    steps_.clear();
    if (response.body_pose) broken += !begun_ || !same(*response.body_pose, now_);
  }

  long count = 0;    ///< steps
  long places = 0;   ///< at which the gap was looked at
  long broken = 0;   ///< steps that do not begin where the body was
  long unknown = 0;  ///< paths whose gap is not known to exceed -kCertain_A; with moving spheres not counted
  double least_gap_A = 1e9;

 private:
  enum class Kind { Placed, Moved, Returned };
  struct Step {
    Kind kind;
    PoseA from, to;
    double fraction;
  };

  static bool same(const PoseA& a, const PoseA& b) {
    return glm::distance(a.place.A, b.place.A) < 1e-11 &&
           glm::length(rotationBetween(a.orientation, b.orientation)) < 1e-11;
  }

  void follow(const Step& s, const SphereMotion* motion) {
    std::unique_ptr<Oracle> moving;
    if (motion) moving = std::make_unique<Oracle>(motion->at(s.fraction), body_->spheres, 1.0);
    const Oracle& in = motion ? *moving : standing_;
    const Oracle::Pose from = Oracle::pose(s.from), to = Oracle::pose(s.to);
    const Oracle::Vec turn = Oracle::rotationVector(from, to);
    const auto gapAt = [&](Oracle::Real t) {
      Oracle::Vec6 by{};
      for (std::size_t i = 0; i < 3; ++i) by[i] = t * (to.place[i] - from.place[i]), by[3 + i] = t * turn[i];
      const auto gap = double(in.minGap_A(in.moved(from, by)));
      least_gap_A = std::min(least_gap_A, gap);
      ++places;
      return gap;
    };
    const double motion_A =
        glm::distance(s.from.place.A, s.to.place.A) + double(std::hypot(turn[0], turn[1], turn[2])) * reach_;
    const auto known = [&](auto& again, double t, double g, double u, double h, int depth) -> bool {
      const double way = motion_A * (u - t);
      if (0.5 * (g + h - way) > -kCertain_A) return true;
      if (depth == 40 || g < -kCertain_A || h < -kCertain_A) return false;
      const double middle = 0.5 * (t + u), m = gapAt(middle);
      return again(again, t, g, middle, m, depth + 1) && again(again, middle, m, u, h, depth + 1);
    };
    const double first = gapAt(0.0), last = gapAt(1.0);
    const bool certain = known(known, 0.0, first, 1.0, last, 0);
    unknown += !motion && !certain;
  }

  std::shared_ptr<const HeldBody> body_;
  Oracle standing_;
  double reach_ = 0.0;
  std::vector<Step> steps_;
  PoseA now_;
  bool begun_ = false;
};

}  // namespace moltact::test
