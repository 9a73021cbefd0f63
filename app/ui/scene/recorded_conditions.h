// The conditions under which a recorded hand was led. While it leads, its workspace, probe, surface and clutch replace the
// scene's own. Window's thread.
#pragma once

#include <optional>

#include "engine/render/camera.h"
#include "engine/servo/servo_step.h"

namespace moltact {

class RecordedConditions {
 public:
  /// A recorded hand leads.
  bool on() const { return now_.has_value(); }
  /// Applies the conditions of a recorded tick, and turns the camera to show the molecule as it was felt. Whether the force
  /// is on remains the choice of the person. Returns whether the contact must begin anew.
  bool lead(const ServoSettings& recorded, ServoSettings& settings, Camera& camera);
  /// Restores what was set before, except the workspace, which must be fitted again. Returns false if no hand led.
  bool end(ServoSettings& settings);

 private:
  std::optional<ServoSettings> now_, before_;
};

}  // namespace moltact
