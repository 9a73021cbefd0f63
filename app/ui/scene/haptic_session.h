// The scene that is touched and drawn: the molecule on the stage, the servo loop, the method in use, the camera, and
// the recent samples. Panels set the public members; everything else is changed by the functions and by the parts, each
// of which has one job and a header of its own. Window's thread.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/ui/scene/atom_pull.h"
#include "app/ui/scene/body_contacts.h"
#include "app/ui/scene/felt_scene.h"
#include "app/ui/scene/fitted_view.h"
#include "app/ui/scene/force_control.h"
#include "app/ui/scene/hand_recording.h"
#include "app/ui/scene/method_watch.h"
#include "app/ui/scene/played_hand.h"
#include "app/ui/scene/scanned_surface.h"
#include "app/ui/scene/scene_look.h"
#include "engine/haptics/methods.h"
#include "engine/molecule/molecule_key.h"

namespace moltact {

/// One tick of the servo loop, with the contact of an exact tracker for the same hand.
struct FeltTick {
  ServoSample sample;
  Contact exact;
};

/// The ticks of a frame by one method, oldest first.
struct FeltTicks {
  std::span<const FeltTick> ticks;
  const Method& method;
};

class HapticSession {
 public:
  explicit HapticSession(ServoClock clock);

  ServoSettings servo_settings;  ///< passed to the servo loop each frame
  Camera camera;
  ViewControls controls;
  SceneLook look{felt_};

  /// The model that is touched; its spheres are at the atoms' present positions.
  const TouchableModel& stage() const { return felt_.stage(); }
  const MoleculeKey& molecule() const { return molecule_; }  ///< the molecule on the stage
  const TouchLog& log() const { return felt_.log; }
  /// The contacts of the body in the hand at the last advance(); empty without a body.
  const LoadedAtoms& bodyContacts() const { return body_contacts_; }
  const MethodWatch& watch() const { return watch_; }
  /// The forces between atoms at the last advance(), by parts.
  const ForceWatch& forces() const { return felt_.forces; }

  // Its parts:
  ServoLink& servo() { return felt_.servo; }
  const ServoLink& servo() const { return felt_.servo; }
  /// The positions of the atoms, and the source that moves them.
  AtomMotion& atoms() { return felt_.atoms; }
  const AtomMotion& atoms() const { return felt_.atoms; }
  /// The view, the hand's workspace, and where the hand begins.
  FittedView& view() { return view_; }
  const FittedView& view() const { return view_; }
  /// Emergency stop, and a force with which a device is tried.
  ForceControl& force() { return force_; }
  /// A sample of a playback in place of the hand's own.
  PlayedHand& playedHand() { return played_; }
  const PlayedHand& playedHand() const { return played_; }
  /// A recording of the hand, and the conditions of a recorded one.
  HandRecording& recording() { return recording_; }
  AtomPull& pull() { return pull_; }
  ScannedSurface& scanned() { return scanned_; }

  /// Shows another molecule in the view of a new scene.
  void show(TouchableModel stage, const MoleculeKey& molecule, const Facing& facing);
  /// The rendering parameters in use.
  TouchSetup touch() const { return felt_.touch(); }
  /// Changes the rendering parameters and keeps an existing contact. Ignores unknown names.
  void setTouch(const TouchSetup& wanted);
  /// Leads the hand of a device that gives force by a task's guide; none: frees it. Keeps an existing contact; the force
  /// begins softly. Called once per frame. Without such a device, with a body in the hand, while a hand is recorded and
  /// while a recorded one is played nothing leads; during playback of an attempt and force trials nothing changes.
  void lead(const std::optional<TaskGuide>& guide);
  /// Whether a guide leads the hand now.
  bool leads() const { return felt_.guide.has_value(); }
  /// Moves the atoms at constant speed to these positions (one sphere for each) within this number of ticks, also
  /// during contact; the picture follows. Returns false if `source` does not own the atoms, or while an earlier motion
  /// is waiting: repeat in a later frame. Also returns false without a model, during playback and while a force is
  /// tried.
  bool moveAtoms(const MotionSource& source, const std::vector<Sphere>& to, int ticks);
  /// Moves the atoms there at once and rebuilds the interaction.
  bool placeAtoms(const MotionSource& source, SharedArray<Sphere> at);
  /// Called once per frame: returns every tick since the last call, valid until the next call; none during a playback.
  /// `timed`: tick times are displayed.
  FeltTicks advance(double dt_s, double now_s, bool timed);
  /// Whether the next frame differs without further input.
  bool live() const { return log().felt() || controls.live() || hand_moved_ || atoms().moving(); }

 private:
  void watchLeftBehind(double dt_s);
  void rebuildInteraction();

  FeltScene felt_;
  ForceControl force_{felt_};
  FittedView view_{felt_, force_, look, camera};
  PlayedHand played_{felt_};
  HandRecording recording_{felt_, view_, camera};
  AtomPull pull_{felt_};
  ScannedSurface scanned_{felt_, force_};
  MoleculeKey molecule_;
  std::string wanted_interaction_ = felt_.built_setup.interaction;  // which the stage may not support
  LoadedAtoms body_contacts_;
  MethodWatch watch_;
  std::vector<FeltTick> ticks_;
  bool hand_moved_ = false;
};

/// Changes the haptic method alone. Ignores unknown names.
void useMethod(HapticSession& scene, std::string_view name);
/// The direction of the reaction on the hand, as a unit vector in the camera's axes; 0 without force.
Vec3 pushInView(const HapticSession& scene);

}  // namespace moltact
