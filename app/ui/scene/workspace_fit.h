// Computes how the scene is placed in the hand's workspace: scale and position for the whole molecule, for a magnified
// part, and for a device. A device's axes are those of the view. HapticSession passes the workspaces to the loop.
// Window's thread.
#pragma once

#include <functional>
#include <optional>

#include "app/ui/scene/servo_link.h"
#include "app/ui/scene/touchable_model.h"
#include "engine/render/camera.h"
#include "engine/render/view_scene.h"
#include "engine/workspace/scale.h"

namespace moltact {

/// Rotates a camera that was fitted to the molecule to its initial view.
using Facing = std::function<void(Camera&, const Molecule&)>;

class WorkspaceFit {
 public:
  WorkspaceFit(const TouchableModel& model, const ServoLink& servo) : model_(model), servo_(servo) {}

  /// The part of the molecule that scenes shown from now on magnify; empty: none.
  std::optional<Region> region;
  /// The region to which the view zooms when a scene is opened or the view is reset; empty: the magnified part, or the
  /// whole.
  std::optional<Region> zoomed;
  /// The view's aspect ratio (width / height), to which the camera is fitted.
  double view_aspect = 1.0;
  /// The user magnifies the surroundings of the probe to fill the workspace.
  bool by_hand = false;

  /// The part to which the view is fitted when a scene is opened.
  const std::optional<Region>& part() const { return zoomed ? zoomed : region; }
  /// The camera rotated by `facing` and fitted to the whole molecule, or to this part of it. `hidden`: atoms that are
  /// not drawn.
  Camera cameraFor(const Camera& now, const Facing& facing, const std::optional<Region>& part, const AtomList& hidden,
                   double probe_A) const;

  /// The workspace for the view, with `toward` behind the middle of the workspace of a device that leads. `now`: the
  /// workspace in use; `felt`: the newest tick.
  Workspace fitted(const Workspace& now, const Camera& camera, PointA toward, double probe_A, const ServoSample& felt);
  /// The scene's workspace with the probe's surroundings magnified, or no longer, for a hand that keeps its position;
  /// and the camera for it.
  Workspace magnified(const Workspace& now, Camera& camera, bool on, const ServoSample& felt);
  /// Whether the workspace no longer fits the view or the leading device.
  bool outdated(const Camera& camera) const;
  /// Whether a device leads and the workspace is fitted to it.
  bool deviceLeads() const { return device_leads_; }
  /// Called once per frame: a new workspace if the hand turns out to be inside the molecule soon after a fit; nothing
  /// if no change is needed.
  std::optional<Workspace> retracted(const ServoSettings& settings, const ServoSample& felt, double dt_s);
  /// The magnification relative to the scale of the whole molecule.
  double magnification(const Workspace& now) const;

 private:
  Workspace ofScene() const;
  double byHand_A_per_mm(const ServoSample& felt) const;

  const TouchableModel& model_;
  const ServoLink& servo_;
  bool device_leads_ = false;
  Camera fitted_;            // the view for which it was fitted
  double fit_left_s_ = 0.0;  // remaining time in which a hand found inside is moved out
};

}  // namespace moltact
