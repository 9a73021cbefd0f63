// Converts mouse and key input in the view into motions of the hand and the camera. Independent of ImGui: the view
// panel passes the input once per frame. Window's thread. Units: pixel, angstrom, newton, second.
#pragma once

#include <optional>

#include "app/ui/scene/servo_link.h"
#include "engine/device/pointer_hand.h"
#include "engine/haptics/sphere_grid.h"
#include "engine/render/camera.h"

namespace moltact {

/// The input over the view in one frame.
struct ViewInput {
  glm::dvec2 size_px{1.0};               ///< of the view
  std::optional<glm::dvec2> pointer_px;  ///< in the view; empty: elsewhere, or the pointer rotates the view
  bool over_control = false;             ///< the pointer is on a control that lies over the view
  bool press = false;                    ///< left button or space is held
  bool release = false;                  ///< Escape: ends the press even while the button is held
  double push_notches = 0.0;
  double zoom_notches = 0.0;
  /// drags since the last frame; the last one rotates the hand
  glm::dvec2 orbit_px{0.0}, pan_px{0.0}, hand_px{0.0};
  glm::dvec2 probe_keys{0.0}, orbit_keys{0.0}, pan_keys{0.0};  ///< x right, y up: -1, 0 or 1
  glm::dvec2 hand_keys{0.0};                                   ///< rotate the hand
  /// rotation of the hand about the viewing direction, clockwise
  double hand_roll_rad = 0.0;
  double zoom_keys = 0.0;                   ///< positive: closer
  std::optional<double> expected_N_per_mm;  ///< the stiffness that the user expects of the surface; empty: its real one
  double dt_s = 1.0 / 60.0;
};

/// The rays of a camera through a view of this size.
ViewRays viewRays(const Camera& camera, glm::dvec2 size_px);

class ViewControls {
 public:
  /// Processes one frame: rotates the camera and leads the hand. With `spheres` null only the camera moves. `felt` is
  /// the servo loop's last tick. `body`: what the hand holds; null: a probe.
  void update(const ViewInput& input, Camera& camera, const SphereGrid* spheres, const ServoSettings& settings,
              const ServoSample& felt, MouseDevice& mouse, const HeldBody* body = nullptr);

  /// Restarts the hand outside a new scene, at `outside_A` in front of `before` toward the viewer. It aims at that
  /// point until pointer or keys lead it.
  void begin(const Camera& camera, PointA before, const Workspace& workspace, double outside_A, MouseDevice& mouse);

  /// The same, with the hand in this pose (in the molecule's space), where it waits for a press.
  void beginAt(const PoseA& hand, const Camera& camera, const Workspace& workspace, MouseDevice& mouse);

  /// The orientation, in the molecule's space, with which the hand starts from the next begin() on; empty: that of the
  /// device's axes.
  void startTurned(const std::optional<Quat>& orientation) { start_ = orientation; }
  /// Where the hand waits for a press from the next begin() on, in the molecule's space; empty: outside, in front of the
  /// view.
  void startAt(const std::optional<PointA>& place) { start_at_ = place; }

  /// Ends a press as Escape does: it begins again when the button or key has been released.
  void letGo() { let_go_ = true; }

  /// While on, pointer and keys lead the hand in the plane through its place that faces the viewer, through all atoms:
  /// the hand pulls what it holds. Notches move it away from the viewer and back.
  void drag(bool on) { drags_ = on; }

  bool pressing() const { return pressing_; }
  double depth_A() const { return hand_.depth_A(); }
  /// The time for which the press has been at rest; 0 without a press and while it slides (unit: second).
  double pressRested_s() const { return press_rested_s_; }
  /// Whether the press aims at empty space.
  bool pressesNothing() const { return pressing_ && !hand_.overSurface(); }
  glm::dvec2 aim_px() const { return hand_.aim_px(); }  ///< the pixel of the view at which the hand aims
  PointA lead() const { return lead_; }
  /// Whether the view was rotated, moved or zoomed in the last frame.
  bool cameraMoved() const { return camera_moved_; }
  /// Whether the user has pressed, and has changed the push; the hint of controls fades once both are true.
  bool hasPressed() const { return has_pressed_; }
  bool hasTurned() const { return has_turned_; }
  /// The user has changed the strength of a press.
  bool hasPushed() const { return has_pushed_; }
  /// Opacity of the hint of controls: 1 until the user has learnt them, then fading to 0.
  double hintStrength() const;
  /// Whether the next frame differs without further input.
  bool live() const;

 private:
  void dragHand(const PointerInput& in, const ServoSettings& settings, MouseDevice& mouse);

  PointerHand hand_;
  Quat orientation_ = kNoRotation;  // of the hand, from the device's axes
  std::optional<Quat> start_;       // in the molecule's space
  std::optional<PointA> start_at_;  // the same
  PointA lead_;
  std::optional<PointA> first_aim_;  // of a scene in which no frame has been processed yet
  double hint_left_s_ = 2.0, press_rested_s_ = 0.0;
  bool pressing_ = false, let_go_ = false, camera_moved_ = false, drags_ = false;
  bool has_pressed_ = false, has_turned_ = false, has_pushed_ = false;
};

}  // namespace moltact
