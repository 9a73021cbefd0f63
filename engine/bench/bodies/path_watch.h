// Judges the path of an exact body between its ticks: whether it leads through a sphere. Compares places along every step
// with all spheres, and uses neither the lists nor the bounds of the exact body. Any one thread. Units: angstrom.
#pragma once

#include <vector>

#include "engine/haptics/body/exact_body.h"
#include "engine/haptics/sphere_motion.h"

namespace moltact::bench {

class PathWatch final : public BodyPathObserver {
 public:
  /// The distance between two compared places, as a motion of the body's surface.
  static constexpr double kStep_A = 0.05;

  /// `through_A`: an overlap by more than this counts.
  PathWatch(std::vector<Sphere> scene, std::shared_ptr<const HeldBody> body, double through_A);

  void placed(const PoseA& at) noexcept override;
  void moved(const PoseA& from, const PoseA& to, double fraction) noexcept override;
  void returned(const PoseA& to) noexcept override;

  /// After a tick that ended at `now`: true if a step since the last call leads through a sphere, or if the steps do not
  /// join the poses. `motion`: of the spheres; null: they stand still.
  bool tunnelled(const PoseA& now, const SphereMotion* motion);

 private:
  struct Step {
    PoseA from, to;
    double fraction = 0.0;
  };
  bool leadsThrough(const Step& step, const SphereMotion* motion) const;

  std::vector<Sphere> scene_;
  std::shared_ptr<const HeldBody> body_;
  double through_, reach_ = 0.0;
  std::vector<Step> steps_;
  std::vector<PoseA> been_;  // poses of this tick
  PoseA at_;
  bool begun_ = false, apart_ = false;
};

}  // namespace moltact::bench
