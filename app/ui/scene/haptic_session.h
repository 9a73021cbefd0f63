// The scene that is touched and drawn: the molecule on the stage, the servo loop, the method in use, the camera, and
// the recent samples. Panels set the public members; everything else is changed by the functions. Window's thread.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/ui/scene/atom_motion.h"
#include "app/ui/scene/body_contacts.h"
#include "app/ui/scene/force_trial.h"
#include "app/ui/scene/force_watch.h"
#include "app/ui/scene/method_watch.h"
#include "app/ui/scene/played_hand.h"
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

struct HeightField;

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
  ViewPartSet shown;  ///< visible parts
  AtomsLook look;     ///< how the molecule is drawn
  ColourBy colour_by = ColourBy::Element;
  ViewControls controls;

  /// The positions of the atoms, and the source that moves them.
  AtomMotion& atoms() { return atoms_; }
  const AtomMotion& atoms() const { return atoms_; }
  /// The model that is touched; its spheres are at the atoms' present positions.
  const TouchableModel& stage() const { return atoms_.model(); }
  const MoleculeKey& molecule() const { return molecule_; }  ///< the molecule on the stage
  ServoLink& servo() { return servo_; }
  const ServoLink& servo() const { return servo_; }
  /// The rendering parameters in use.
  TouchSetup touch() const;
  const std::string& method() const { return constructed_with_.method; }
  const TouchLog& log() const { return log_; }
  /// The contacts of the body in the hand at the last advance(); empty without a body.
  const LoadedAtoms& bodyContacts() const { return body_contacts_; }
  const MethodWatch& watch() const { return watch_; }
  /// The forces between atoms at the last advance(), by parts.
  const ForceWatch& forces() const { return forces_; }

  /// Shows another molecule in the view of a new scene.
  void show(TouchableModel stage, const MoleculeKey& molecule, const Facing& facing);
  /// Restarts the scene with the same molecule, keeping the records of the methods.
  void beginAgain(const Facing& facing);
  /// Discards the contact; the force drops to zero and rises softly. The view is unchanged.
  void startSoftly();
  /// The same, with a point rotated to the front and into the middle of the view; the hand begins in front of it.
  void beginAgainAt(PointA place);
  /// The same, with the hand at a pose of the body that it holds. A mouse's hand waits there for the next press, in the
  /// present view, and the body yields to what acts on it there. A device's hand stays where it is: the view turns, and
  /// the scene moves in the device's workspace, so that the hand has this pose in the molecule.
  void holdAt(const PoseA& body);
  /// The placement of the scene in the hand's workspace.
  WorkspaceFit& fit() { return fit_; }
  const WorkspaceFit& fit() const { return fit_; }
  /// The camera rotated by `facing` and fitted to the whole molecule, or to this part of it.
  Camera cameraFor(const Facing& facing, const std::optional<Region>& part) const;
  /// Magnifies, until the view is reset or another scene begins: the surroundings of the probe fill the hand's
  /// workspace and are drawn larger by the same factor. Hand and probe keep their positions; the force starts softly.
  void magnify(bool on);
  /// Fits the molecule, or its magnified part, to the workspace of another device; the hand begins in front of it.
  void fitRoomOfDevice();
  /// Called once per frame. Aligns the device's axes with the screen's, and the middle of its workspace with the middle
  /// of the view. After a change of view or device the hand is repositioned, so that nothing is dragged along.
  void followView();
  /// Restores camera and scale of the scene's beginning. Does nothing without a molecule.
  void resetView(const Facing& facing);
  /// Changes the rendering parameters and keeps an existing contact. Ignores unknown names.
  void setTouch(const TouchSetup& wanted);
  /// Changes the haptic method.
  void useMethod(std::string_view name);

  /// Moves the atoms at constant speed to these positions (one sphere for each) within this number of ticks, also
  /// during contact; the picture follows. Returns false if `source` does not own the atoms, or while an earlier motion
  /// is waiting: repeat in a later frame. Also returns false without a model, during playback and while a force is
  /// tested.
  bool moveAtoms(const MotionSource& source, const std::vector<Sphere>& to, int ticks);
  /// Moves the atoms there at once and rebuilds the interaction.
  bool placeAtoms(const MotionSource& source, SharedArray<Sphere> at);

  /// Holds these atoms of the scene, at their centre of mass, by a spring (engine/haptics/pull_spring.h) instead of
  /// touching, until called with none or the atoms are placed elsewhere. `masses`: one for each; empty: equal ones. Does
  /// nothing during playback, while a force is tested and with a body in the hand.
  void pull(std::vector<std::uint32_t> atoms, std::vector<double> masses = {});
  /// The atoms that are held; empty: the scene is touched.
  const std::vector<std::uint32_t>& pulled() const { return pulled_; }

  /// The hand touches this scanned surface with a point instead of the scene, until called with null or the scene begins
  /// anew. Begins from outside. Does nothing during playback, while a force is tested and with a body in the hand.
  /// `like` are spheres whose surface, inflated by the probe, is nearly the same; a mouse's hand hovers over them.
  void touchField(std::shared_ptr<const HeightField> field, std::shared_ptr<const SphereGrid> like = nullptr);
  /// The touched surface; null: the scene is touched.
  const std::shared_ptr<const HeightField>& touchedField() const { return field_; }
  /// The spheres over which a mouse's hand hovers; null without a scene.
  const SphereGrid* spheresUnderPointer() const { return field_like_ ? field_like_.get() : stage().spheres.get(); }

  /// While on, the scene is not visible and the hand feels nothing.
  void rest(bool on) { resting_ = on; }

  /// Called once per frame: returns every tick since the last call, valid until the next call. `timed`: tick times are
  /// displayed.
  FeltTicks advance(double dt_s, double now_s, bool timed);

  /// Emergency stop: no force from the next tick on until called with false. Takes effect at once, whatever is
  /// displayed.
  void stopForce(bool stopped);
  /// Applies this force to the right until endTry(), independent of the scene, which is not felt meanwhile. Returns
  /// false and does nothing during playback or an emergency stop.
  bool tryForce(double force_N);
  /// Restores the scene's force softly, from outside.
  void endTry();
  bool trying() const { return trial_.on(); }

  /// Applies the conditions of a recording (workspace, probe, surface and clutch) instead of the scene's own; null
  /// restores those. The clutch is then that of the next device.
  void leadBy(const ServoSettings* recorded);
  /// Starts a recording at a new contact. Returns false if nothing can be felt.
  bool beginRecording();

  /// Shows a sample instead of the hand's: the log contains it, there is no force, and advance() returns no ticks.
  /// Empty: the hand again, from outside.
  void showSample(const std::optional<ServoSample>& sample);
  bool playing() const { return bool(played_); }

  /// Whether the contact is with an atom that the scene does not draw; its name would reveal what is to be felt.
  bool touchesUnseen(const Contact& contact) const;
  /// The direction of the reaction on the hand, as a unit vector in the camera's axes; 0 without force.
  Vec3 pushInView() const;
  /// The colours of a scheme for the molecule on the stage, what the hand holds and the medium of its forces. Null for
  /// "element", "chain" and unknown names. That of the potential is pending: PotentialColours computes it.
  std::shared_ptr<const Colouring> colouring(std::string_view scheme) const;
  /// The atoms' fluctuation in a trajectory, which the scheme of that name shows (unit: angstrom); empty: none is known.
  void setFluctuation_A(std::vector<float> of_atom) { fluctuation_A_ = std::move(of_atom); }
  /// Whether the scene draws no atom of its molecule.
  bool drawsNothing() const;
  /// Whether the next frame differs without further input.
  bool live() const { return log_.felt() || controls.live() || hand_moved_ || atoms_.moving(); }

 private:
  void handBegins(PointA before);
  void fitRoom(PointA toward);
  void retract(double dt_s);
  void bringToHand();
  void watchLeftBehind(double dt_s);
  std::unique_ptr<Interaction> interactionHere(const Contact& contact, const PoseA& hand);
  std::unique_ptr<Interaction> freshInteraction();
  void rebuildInteraction();
  void letGo();
  ServoSettings effectiveSettings(bool trying) const;

  MoleculeKey molecule_;
  ServoLink servo_;
  AtomMotion atoms_{servo_};
  WorkspaceFit fit_{atoms_.model(), servo_};
  TouchSetup constructed_with_;  // properties that need no rebuild are only in servo_settings
  std::string wanted_interaction_ = constructed_with_.interaction;  // which the stage may not support yet, or no longer
  TouchLog log_;
  LoadedAtoms body_contacts_;
  MethodWatch watch_;
  ForceWatch forces_;
  std::vector<FeltTick> felt_;
  PlayedHand played_;
  ForceTrial trial_{servo_};
  RecordedConditions recorded_;
  std::vector<float> fluctuation_A_;
  std::vector<std::uint32_t> pulled_;
  std::vector<double> pulled_masses_;
  std::optional<PoseA> brought_;  // what the device's hand is to hold, as soon as its own pose is known
  std::shared_ptr<const HeightField> field_;
  std::shared_ptr<const SphereGrid> field_like_;
  bool hand_moved_ = false, resting_ = false;
};

}  // namespace moltact
