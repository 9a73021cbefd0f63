// How the scene lies in the room of the hand: the scale and the place for the whole molecule, for a part that a lesson or the
// person magnifies, and for a device in the hand, whose axes are those of the view. Computes workspaces; HapticSession hands
// them over. Window's thread.
#pragma once

#include <functional>
#include <optional>

#include "app/ui/scene/servo_link.h"
#include "app/ui/scene/touchable_model.h"
#include "engine/render/camera.h"
#include "engine/render/view_scene.h"
#include "engine/workspace/scale.h"

namespace moltact {

/// Turns a camera that has been fitted to the molecule the way it is to be seen.
using Facing = std::function<void(Camera&, const Molecule&)>;

class WorkspaceFit {
 public:
  WorkspaceFit(const TouchableModel& model, const ServoLink& servo) : model_(model), servo_(servo) {}

  /// The part of the molecule that the scenes shown from now on magnify; nothing: none.
  std::optional<Region> region;
  /// What the view comes close to when a scene is opened or the view is reset; nothing: what is magnified, or the whole.
  std::optional<Region> zoomed;
  /// The view's width over its height, to which the camera is fitted.
  double view_aspect = 1.0;
  /// What lies round the probe fills the room of the hand, as the person asked.
  bool by_hand = false;

  /// The part to which the view is fitted when a scene is opened.
  const std::optional<Region>& part() const { return zoomed ? zoomed : region; }
  /// The camera turned by `facing` and as near as the whole molecule, or this part of it, needs. `hidden`: atoms that are
  /// not drawn.
  Camera cameraFor(const Camera& now, const Facing& facing, const std::optional<Region>& part, const AtomList& hidden,
                   double probe_A) const;

  /// The workspace for the view, with `toward` behind the middle of the room of a device that leads. `now`: the workspace
  /// in use; `felt`: the newest tick.
  Workspace fitted(const Workspace& now, const Camera& camera, PointA toward, double probe_A, const ServoSample& felt);
  /// The scene's workspace with what lies round the probe magnified by hand, or not any more, for a hand that stays where
  /// it is; and the camera for it.
  Workspace magnified(const Workspace& now, Camera& camera, bool on, const ServoSample& felt);
  /// Whether the workspace no longer suits the view or the device that leads.
  bool outdated(const Camera& camera) const;
  /// A device leads, and the workspace is fitted to it.
  bool deviceLeads() const { return device_leads_; }
  /// Once a frame: the workspace for a hand that turns out to be inside the molecule soon after it was fitted; nothing
  /// where it need not change.
  std::optional<Workspace> retracted(const ServoSettings& settings, const ServoSample& felt, double dt_s);
  /// How many times larger than the whole molecule's scale.
  double magnification(const Workspace& now) const;

 private:
  Workspace ofScene() const;
  double byHand_A_per_mm(const ServoSample& felt) const;

  const TouchableModel& model_;
  const ServoLink& servo_;
  bool device_leads_ = false;
  Camera fitted_;            // to this view
  double fit_left_s_ = 0.0;  // so long a hand that turns out to be inside is taken out
};

}  // namespace moltact
