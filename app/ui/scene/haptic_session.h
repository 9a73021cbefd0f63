// The scene that is touched and seen: the molecule on the stage, the servo loop that follows the hand over it, the
// method in use, the camera, and what was felt. Panels set the public members; the rest changes through the functions.
// Window's thread.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/ui/scene/atom_motion.h"
#include "app/ui/scene/method_watch.h"
#include "app/ui/scene/recorded_conditions.h"
#include "app/ui/scene/servo_link.h"
#include "app/ui/scene/touch_log.h"
#include "app/ui/scene/touchable_model.h"
#include "app/ui/scene/view_controls.h"
#include "app/ui/scene/workspace_fit.h"
#include "engine/haptics/methods.h"
#include "engine/molecule/molecule_key.h"
#include "engine/render/view_scene.h"

namespace moltact {

/// One tick of the servo loop, and what an exact tracker led by the same hand found.
struct FeltTick {
  ServoSample sample;
  Contact exact;
};

/// The ticks of a frame, oldest first, which one method made.
struct FeltTicks {
  std::span<const FeltTick> ticks;
  const Method& method;
};

class HapticSession {
 public:
  explicit HapticSession(ServoClock clock);

  ServoSettings servo_settings;  ///< as they are handed to the servo loop each frame
  Camera camera;
  ViewPartSet shown;  ///< parts of the picture
  AtomsLook look;     ///< how the molecule is drawn
  ColourBy colour_by = ColourBy::Element;
  ViewControls controls;

  /// Where the atoms are, and which source moves them.
  AtomMotion& atoms() { return atoms_; }
  const AtomMotion& atoms() const { return atoms_; }
  /// What is touched: its spheres are where the atoms are now.
  const TouchableModel& stage() const { return atoms_.model(); }
  const MoleculeKey& molecule() const { return molecule_; }  ///< which molecule is on the stage
  ServoLink& servo() { return servo_; }
  const ServoLink& servo() const { return servo_; }
  /// What the scene is felt with.
  TouchSetup touch() const;
  const std::string& method() const { return made_with_.method; }
  const TouchLog& log() const { return log_; }
  const MethodWatch& watch() const { return watch_; }

  /// Another molecule; the view is set as for a new scene.
  void show(TouchableModel stage, const MoleculeKey& molecule, const Facing& facing);
  /// The same molecule as if it had just been opened, keeping what was found out about the methods.
  void beginAgain(const Facing& facing);
  /// Forgets the contact where the hand is: the force goes to zero and grows from nothing. The view stays.
  void startSoftly();
  /// The same, with a place turned to the front and in the middle of the view; the hand begins before it.
  void beginAgainAt(PointA place);
  /// How the scene lies in the room of the hand.
  WorkspaceFit& fit() { return fit_; }
  const WorkspaceFit& fit() const { return fit_; }
  /// The camera turned by `facing` and as near as the whole molecule, or this part of it, needs.
  Camera cameraFor(const Facing& facing, const std::optional<Region>& part) const;
  /// By hand, until the view is reset or another scene begins: what lies round the probe fills the room of the hand,
  /// and is seen that much larger. Hand and probe stay, the force begins softly.
  void magnify(bool on);
  /// Another device leads: the molecule, or what is magnified, lies in its room, and the hand begins before it.
  void fitRoomOfDevice();
  /// Once a frame. With a device in the hand its axes are the screen's, and what is in the middle of the view lies
  /// behind the middle of its room; where view or device have changed the hand is placed again, so that nothing is
  /// dragged along.
  void followView();
  /// Camera and scale as they are when a scene is opened. Does nothing without a molecule.
  void resetView(const Facing& facing);
  /// Feels the scene with something else, keeping a contact that there is. A word that is not known stays as it was.
  void setTouch(const TouchSetup& wanted);
  /// The same with another haptic method.
  void useMethod(std::string_view name);

  /// Moves the atoms evenly to these places (a sphere for each) in so many ticks, while they are touched; the picture
  /// follows. False where `source` does not own the atoms, and while an earlier motion waits to begin: try again in a later
  /// frame. False also without a stage, while a hand is played or a force is tried.
  bool moveAtoms(const MotionSource& source, const std::vector<Sphere>& to, int ticks);
  /// The atoms are there at once, and what is felt begins anew. False, without any change, where `source` does not own the
  /// atoms, and without a stage.
  bool placeAtoms(const MotionSource& source, SharedArray<Sphere> at);

  /// While nobody looks at the scene the hand feels nothing.
  void rest(bool on) { resting_ = on; }

  /// Once a frame: takes up every tick since the last one. `timed`: someone looks at how long ticks take. The ticks
  /// hold until the next call.
  FeltTicks advance(double dt_s, double now_s, bool timed);

  /// Panic: no force from the next tick on until false again. Handed over at once, whatever is shown.
  void stopForce(bool stopped);
  /// Pulls to the device's right with that force until endTry(), whatever is on the stage; the scene is not felt
  /// meanwhile. Does nothing, and gives false, while a hand is played or all force is stopped.
  bool tryForce(double force_N);
  /// The scene is felt again, softly and from outside.
  void endTry();
  bool trying() const { return servo_.trying(); }

  /// The conditions under which a recorded hand was led: workspace, probe, surface and clutch stand in for the scene's
  /// own until null; the clutch is then its next device's.
  void leadBy(const ServoSettings* recorded);
  /// Records from a new contact on; false where there is nothing to be felt.
  bool beginRecording();

  /// A sample that is shown in the place of the hand's: it stands in the log, no force is given and advance() gives no
  /// ticks. Nothing: the hand again, from outside.
  void play(const std::optional<ServoSample>& sample);
  bool playing() const { return played_.has_value(); }

  /// An atom that the scene does not draw is touched: its name would tell what the hand is to find out.
  bool touchesUnseen(const Contact& contact) const;
  /// Whereto the surface pushes the hand, as a unit vector in the camera's axes; 0 where no force is given.
  Vec3 pushInView() const;
  /// The scene draws no atom of its molecule.
  bool drawsNothing() const;
  /// The next frame would look different by itself.
  bool live() const { return log_.felt() || controls.live() || hand_moved_ || atoms_.moving(); }

 private:
  void handBegins(PointA before);
  void fitRoom(PointA toward);
  void retract(double dt_s);
  void watchLeftBehind(double dt_s);
  std::unique_ptr<Interaction> freshInteraction() const;
  void rebuildInteraction();
  ServoSettings effectiveSettings(bool trying) const;

  MoleculeKey molecule_;
  ServoLink servo_;
  AtomMotion atoms_{servo_};
  WorkspaceFit fit_{atoms_.model(), servo_};
  TouchSetup made_with_;  // what the servo loop does itself of it is in servo_settings only
  std::string wanted_interaction_ = made_with_.interaction;  // which the stage may not bear yet, or no more
  TouchLog log_;
  MethodWatch watch_;
  std::vector<FeltTick> felt_;
  std::optional<ServoSample> played_;
  double played_owed_s_ = 0.0;
  RecordedConditions recorded_;
  bool hand_moved_ = false, resting_ = false;
};

}  // namespace moltact
