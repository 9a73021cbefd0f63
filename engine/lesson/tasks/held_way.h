// Follows what the hand leads through the scene, probe or body, from sample to sample: where it is, and whether it came
// there without a jump. Used as tasks are (task.h). Units: angstrom, radian.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/haptics/body/held_body.h"
#include "engine/lesson/hand_plan.h"
#include "engine/lesson/pose_search.h"
#include "engine/lesson/scene_forces.h"
#include "engine/lesson/touch_sample.h"

namespace moltact {

class HeldWay {
 public:
  /// A longer step between two samples is a jump. A hand moves by less than this in 30 ms, and by far less in a tick.
  static constexpr double kJump_A = 3.0, kJump_rad = 0.5;

  /// Takes a sample; `dt_s` as in Task::onSample. Returns false if the sample does not continue the previous one. That
  /// is so for the first sample, after the hand was put down or jumped, after a gap in time, and for a body or probe
  /// that began inside.
  bool tick(const TouchSample& sample, double dt_s);
  void restart() { *this = HeldWay(); }

  /// Of the last sample: the body as it is shown, or the contact point of the probe. The point is that of the exact
  /// tracker, so a method that loses the surface cannot mislead the task.
  const PoseA& pose() const { return now_; }
  /// Of the previous sample; valid if tick() returned true.
  const PoseA& before() const { return before_; }

 private:
  PoseA now_, before_;
  bool there_ = false;
};

/// The poses of a body beside a goal.
class PoseGoal {
 public:
  PoseGoal(std::shared_ptr<const HeldBody> body, const PoseA& goal);
  const HeldBody& body() const { return *body_; }
  const PoseA& goal() const { return goal_; }

  /// The root of the mean squared distance of the body's atoms from their places in the goal.
  double rmsd_A(const PoseA& pose) const;
  double turned_rad(const PoseA& pose) const;
  /// Whether the springs of a body held by `springs`, one per atom, are stretched by more than `within_A` (root mean
  /// square over the atoms). If so, its atoms are elsewhere than the body that is shown.
  bool stretched(const TouchSample& s, double within_A) const;

 private:
  std::shared_ptr<const HeldBody> body_;
  PoseA goal_;
  glm::dmat3 spread_{0.0};  // mean of l l^T over the atoms' places l about the middle
};

/// How far a body may be from a goal.
struct PoseTolerance {
  double within_A = 1.0, turned_rad = 0.35;

  bool allows(const PoseGoal& goal, const PoseA& pose, double part = 1.0) const {
    return goal.rmsd_A(pose) <= part * within_A && goal.turned_rad(pose) <= part * turned_rad;
  }
};

/// The pose that an author wrote (pose_text.h); if the text is empty, that of the molecule's file.
PoseA writtenGoal(std::string_view text, const HeldBody& body);

/// The goal, or else a pose well within the tolerance in which the body overlaps nothing; with a `seed` other than 0 the
/// goal does not count.
std::optional<PoseA> freePoseAt(const PoseGoal& goal, const PoseTolerance& tolerance, const PoseSpace& space,
                                std::uint64_t seed = 0);

/// The wells beside a goal that `falls` falls lead to, the deepest first: from the goal and from free poses within the
/// tolerance. A fall that leads out of the tolerance ends at the last pose within it, where a hand can hold the body.
std::vector<Well> wellsBeside(const PoseGoal& goal, const PoseTolerance& tolerance, const SceneForces& forces,
                              int falls);

/// PoseSearch::reach_A for a path out of the scene.
double searchReach_A(const SphereGrid& spheres, const HeldBody& body);

/// Puts the hand down at the first pose, moves the scene's atoms to `share` unless it is negative, and leads along the
/// others; at the last one it waits.
HandPlan planAlong(const std::vector<PoseA>& way, double share, double wait_s);

}  // namespace moltact
