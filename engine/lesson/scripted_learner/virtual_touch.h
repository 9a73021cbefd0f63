// A molecule under a scripted hand on a virtual clock, with the same servo tick and trackers as under a real hand. Each
// tick is one millisecond and is computed as fast as possible. One thread, not the haptic one. Units: angstrom, newton,
// second.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "engine/haptics/interactions.h"
#include "engine/haptics/methods.h"
#include "engine/lesson/hand_plan.h"
#include "engine/lesson/lesson.h"
#include "engine/lesson/tasks/task.h"
#include "engine/lesson/touch_sample.h"
#include "engine/molecule/molecule.h"
#include "engine/servo/servo_step.h"

namespace moltact {

class VirtualTouch {
 public:
  /// Sets the scene of a step and its molecule; the hand begins outside. The clock continues across scenes.
  void begin(std::shared_ptr<const Molecule> molecule, const SceneSpec& scene);
  /// Applies the changes of the scene that a task requests; a default value restores the lesson's scene.
  void setStage(const TaskStage& stage);
  /// Selects another method in its initial state. Ignores unknown names.
  void useMethod(std::string_view name);

  /// Moves the hand there without a path.
  void place(const PoseA& hand);
  /// Advances one millisecond with the hand at this pose. A held body moves with it.
  TouchSample tick(const PoseA& hand);

  const SphereGrid& spheres() const { return *spheres_; }
  HandPlanInput view(int attempt) const;
  const PoseA& hand() const { return hand_; }
  double time_s() const { return double(ticks_) * kTick_s; }

 private:
  void feelWith(const TouchSetup& touch);

  std::shared_ptr<const Molecule> molecule_;
  std::shared_ptr<const SphereGrid> spheres_;
  std::shared_ptr<const HeldBody> body_;  // what the hand holds; null: a probe
  std::unique_ptr<Interaction> felt_;
  std::unique_ptr<Interaction> exact_;  // the reference of the method in use (referenceOf())
  TouchSetup touch_;
  std::string_view method_;    // name of the method in use
  bool is_reference_ = false;  // the method in use gives the same contact as exact_
  SceneSpec scene_;
  TaskStage stage_;
  ServoSettings settings_;
  ServoStep step_;
  DevicePose pose_;
  PoseA hand_;
  std::uint64_t ticks_ = 0;
};

}  // namespace moltact
