// What overrides the scene's force: the emergency stop, a constant force to the right with which a device is tried, and
// a scene that is not visible. Window's thread. Unit: newton.
#pragma once

#include "app/ui/scene/felt_scene.h"

namespace moltact {

/// The settings of the servo loop during a trial: those of the scene, with workspace, spring and clutch of the trial.
ServoSettings trialSettings(const ServoSettings& of_scene);

class ForceControl {
 public:
  explicit ForceControl(FeltScene& felt) : felt_(felt) {}

  /// Emergency stop: no force from the next tick on until called with false. Takes effect at once, whatever is
  /// displayed.
  void stop(bool stopped);
  /// Applies this force to the right until endTrial(), independent of the scene, which is not felt meanwhile. Returns
  /// false and does nothing during playback or an emergency stop.
  bool tryOut(double force_N);
  /// Restores the scene's force softly, from outside. The next interaction of the scene also ends a trial.
  void endTrial();
  bool trying() const { return felt_.servo.trying(); }
  /// While on, the scene is not visible and the hand feels nothing.
  void rest(bool on) { felt_.resting = on; }
  /// Discards the contact; the force drops to zero and rises softly. The view is unchanged.
  void startSoftly();

 private:
  FeltScene& felt_;
};

}  // namespace moltact
