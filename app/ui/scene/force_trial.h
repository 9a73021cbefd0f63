// A constant force to the right with which a device is tried, independent of the scene, which is not felt meanwhile.
// Window's thread. Unit: newton.
#pragma once

#include "app/ui/scene/servo_link.h"

namespace moltact {

class ForceTrial {
 public:
  explicit ForceTrial(ServoLink& servo) : servo_(servo) {}

  /// Applies the force from the next tick on. The next interaction of the scene ends it (ServoLink::setInteraction).
  void begin(double force_N, const ServoSettings& of_scene);
  bool on() const { return servo_.trying(); }
  /// The settings of the servo loop during a trial: those of the scene, with workspace, spring and clutch of the trial.
  static ServoSettings settings(const ServoSettings& of_scene);

 private:
  ServoLink& servo_;
};

}  // namespace moltact
