// A molecule under a scripted hand on a virtual clock, with the same servo tick and trackers as under a real hand. Each
// tick is one millisecond and is computed as fast as possible. One thread, not the haptic one. Units: angstrom, newton,
// second.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "engine/haptics/interactions.h"
#include "engine/haptics/methods.h"
#include "engine/haptics/sphere_motion.h"
#include "engine/lesson/hand_plan.h"
#include "engine/lesson/lesson.h"
#include "engine/lesson/tasks/task.h"
#include "engine/lesson/touch_sample.h"
#include "engine/molecule/molecule.h"
#include "engine/servo/servo_step.h"
#include "engine/structure/superposition.h"

namespace moltact {

class VirtualTouch {
 public:
  /// Sets the scene of a step and its molecule; the hand begins outside. The clock continues across scenes.
  void begin(std::shared_ptr<const Molecule> molecule, const SceneSpec& scene);
  /// The two structures of the scene's atoms; null: they do not move. Until begin() is called again.
  void setStructures(std::shared_ptr<const TwoStates> states);
  /// The scene's atoms move evenly to a share of the way to the second structure, from the next tick on.
  void moveTo(double share);
  bool moving() const { return motion_ && fraction_ < 1.0; }
  /// The changes of the scene that a task asks for; a default value for the scene as the lesson has it.
  void setStage(const TaskStage& stage);
  /// Leads the hand by a guide from the next tick on; none: frees it. A guide that is felt alike changes nothing.
  void setGuide(const std::optional<TaskGuide>& guide);
  /// Selects another method in its initial state. Ignores unknown names.
  void useMethod(std::string_view name);

  /// Moves the hand there without a path.
  void place(const PoseA& hand);
  /// Advances one millisecond with the hand at this pose. A held body moves with it.
  TouchSample tick(const PoseA& hand);

  const SphereGrid& spheres() const { return *spheres_; }
  HandPlanInput view(int attempt) const;
  const PoseA& hand() const { return hand_; }
  const Workspace& workspace() const { return settings_.workspace; }
  double time_s() const { return double(ticks_) * kTick_s; }

 private:
  void feelWith(const TouchSetup& touch);
  std::unique_ptr<Interaction> made(const TouchSetup& touch) const;

  std::shared_ptr<const Molecule> molecule_;
  std::shared_ptr<const SphereGrid> spheres_;
  std::shared_ptr<const HeldBody> body_;  // what the hand holds; null: a probe
  std::unique_ptr<Interaction> felt_;
  // The reference of the method in use (referenceOf()); null if what is felt is what it would give.
  std::unique_ptr<Interaction> exact_;
  std::optional<TaskGuide> guide_;
  std::optional<Vec3> last_scp_A_;  // of the contact of the last tick
  TouchSetup touch_;
  std::string_view method_;  // its name in the table of methods
  std::shared_ptr<const TwoStates> states_;
  std::vector<std::shared_ptr<const SphereGrid>> structures_;  // the scene's spheres in both, once they are needed
  std::shared_ptr<const SphereMotion> motion_;                 // that they are in, or have come to the end of
  double fraction_ = 0.0, share_ = 0.0;
  SceneSpec scene_;
  TaskStage stage_;
  ServoSettings settings_;
  ServoStep step_;
  DevicePose pose_;
  PoseA hand_;
  std::uint64_t ticks_ = 0;
};

}  // namespace moltact
