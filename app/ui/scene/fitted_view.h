// Keeps the view, the hand's workspace and the place of the hand together: where a scene begins, a part of it that is
// magnified, a pose that the held body takes, another view or device. Window's thread.
#pragma once

#include <optional>

#include "app/ui/scene/force_control.h"
#include "app/ui/scene/scene_look.h"
#include "app/ui/scene/workspace_fit.h"

namespace moltact {

class FittedView {
 public:
  FittedView(FeltScene& felt, ForceControl& force, const SceneLook& look, Camera& camera)
      : fit(felt.atoms.model(), felt.servo), felt_(felt), force_(force), look_(look), camera_(camera) {}

  /// The placement of the scene in the hand's workspace.
  WorkspaceFit fit;

  /// The camera rotated by `facing` and fitted to the whole molecule, or to this part of it.
  Camera cameraFor(const Facing& facing, const std::optional<Region>& part) const;
  /// Restores camera and scale of the scene's beginning. Does nothing without a molecule.
  void reset(const Facing& facing);
  /// Restarts the scene with the same molecule, keeping the records of the methods.
  void beginAgain(const Facing& facing);
  /// The same, with a point rotated to the front and into the middle of the view; the hand begins in front of it.
  void beginAgainAt(PointA place);
  /// The hand begins in front of the middle of the present view, to which the workspace is fitted.
  void beginHere();
  /// Restarts the scene with the hand at a pose of the body that it holds. A mouse's hand waits there for the next press,
  /// in the present view, and the body yields to what acts on it there. A device's hand stays where it is: the view
  /// turns, and the scene moves in the device's workspace, so that the hand has this pose in the molecule.
  void holdAt(const PoseA& body);
  /// Magnifies, until the view is reset or another scene begins: the surroundings of the probe fill the hand's
  /// workspace and are drawn larger by the same factor. Hand and probe keep their positions; the force starts softly.
  void magnify(bool on);
  /// Fits the molecule, or its magnified part, to the workspace of another device; the hand begins in front of it.
  void fitDevice();
  /// Called once per frame. Aligns the device's axes with the screen's, and the middle of its workspace with the middle
  /// of the view. After a change of view or device the hand is repositioned, so that nothing is dragged along.
  void follow();
  /// Called once per frame after its ticks: brings a device's hand to the pose of holdAt(), or moves a molecule that was
  /// placed onto the hand.
  void advance(double dt_s);

 private:
  void handBegins(PointA before);
  void fitRoom(PointA toward);
  void retract(double dt_s);
  void bringToHand();

  FeltScene& felt_;
  ForceControl& force_;
  const SceneLook& look_;
  Camera& camera_;
  std::optional<PoseA> brought_;  // what the device's hand is to hold, as soon as its own pose is known
};

}  // namespace moltact
