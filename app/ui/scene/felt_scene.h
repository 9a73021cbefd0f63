// What the hand feels: the interaction with the scene, the settings of the servo loop, and what takes the scene's place
// meanwhile. The parts of HapticSession share it; each of them changes the members that its comment names. Window's
// thread.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "app/ui/scene/atom_motion.h"
#include "app/ui/scene/force_watch.h"
#include "app/ui/scene/recorded_conditions.h"
#include "app/ui/scene/servo_link.h"
#include "app/ui/scene/touch_log.h"
#include "app/ui/scene/touchable_model.h"
#include "app/ui/scene/view_controls.h"
#include "engine/haptics/touch_setup.h"
#include "engine/lesson/tasks/task.h"

namespace moltact {

struct HeightField;

class FeltScene {
 public:
  FeltScene(ServoClock clock, ServoSettings& settings_of_panels, ViewControls& controls_of_view)
      : settings(settings_of_panels), controls(controls_of_view), servo(clock) {}

  ServoSettings& settings;
  ViewControls& controls;
  ServoLink servo;
  AtomMotion atoms{servo};
  /// The setup with which the interaction was made. Properties that need no rebuild are only in `settings`.
  TouchSetup built_setup;
  TouchLog log;
  ForceWatch forces;

  // What takes the scene's place:
  std::optional<ServoSample> played;           ///< the hand of a playback (PlayedHand)
  RecordedConditions recorded;                 ///< of a recorded hand (HandRecording)
  bool resting = false;                        ///< the scene is not visible (ForceControl)
  std::vector<std::uint32_t> pulled;           ///< atoms that a spring holds (AtomPull)
  std::vector<double> pulled_masses;           ///< one for each of them, or none
  std::optional<TaskGuide> guide;              ///< what leads a device's hand (HapticSession::lead)
  double guide_A_per_mm = 0.0;                 ///< the scale for which it was made
  std::shared_ptr<const HeightField> scanned;  ///< a scanned surface (ScannedSurface)
  std::shared_ptr<const SphereGrid> scanned_like;

  /// The model that is touched; its spheres are at the atoms' present positions.
  const TouchableModel& stage() const { return atoms.model(); }
  /// The rendering parameters in use.
  TouchSetup touch() const;
  /// Whether the hand's own contact is felt: nothing is played back, and no force is tried.
  bool ownHand() const { return !played && !servo.trying(); }

  /// The settings for the servo loop. There is no force while the scene is not visible or a hand is played back.
  ServoSettings settingsOfScene() const;
  /// The same, but during a force trial those of the trial.
  ServoSettings settingsNow() const;
  void passSettings() { servo.loop().setSettings(settingsNow()); }

  /// Makes the interaction for this contact at the hand, with what pulls or replaces the scene.
  std::unique_ptr<Interaction> interactionAt(const Contact& contact, const PoseA& hand);
  /// The same without a contact; null during a playback.
  std::unique_ptr<Interaction> freshInteraction();
  /// Touches the scene again: no atoms are pulled, no surface replaces it, and nothing leads the hand.
  void letGo();
};

}  // namespace moltact
