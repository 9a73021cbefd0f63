// The effect of a person's mouse and keys on the view: the hand that pushes and the camera that looks. No ImGui here:
// the view panel says what was done, once a frame. Window's thread. Units: pixel, angstrom, newton, second.
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
  std::optional<glm::dvec2> pointer_px;  ///< in the view; none: elsewhere, or the pointer turns the view
  bool press = false;                    ///< left button or space held
  bool release = false;                  ///< Escape: lets go even while the button is held
  double push_notches = 0.0;
  double zoom_notches = 0.0;
  glm::dvec2 orbit_px{0.0}, pan_px{0.0}, hand_px{0.0};         ///< drags since the last frame; the last turns the hand
  glm::dvec2 probe_keys{0.0}, orbit_keys{0.0}, pan_keys{0.0};  ///< x right, y up: -1, 0 or 1
  glm::dvec2 hand_keys{0.0};                                   ///< turn the hand
  double hand_roll_rad = 0.0;                                  ///< of the hand round the view's axis, clockwise
  double zoom_keys = 0.0;                                      ///< positive: closer
  std::optional<double> expected_N_per_mm;  ///< how hard the person expects the surface to push back; none: as it does
  double dt_s = 1.0 / 60.0;
};

/// The rays of a camera through a view of this size.
ViewRays viewRays(const Camera& camera, glm::dvec2 size_px);

class ViewControls {
 public:
  /// One frame: turns the camera and leads the hand. `spheres` may be null: only the camera moves. `felt` is the servo
  /// loop's last tick. `body`: what the hand holds; null: the probe.
  void update(const ViewInput& input, Camera& camera, const SphereGrid* spheres, const ServoSettings& settings,
              const ServoSample& felt, MouseDevice& mouse, const HeldBody* body = nullptr);

  /// The hand starts again, outside: at a new scene. It comes from `outside_A` in front of the place `before`, toward
  /// the viewer, and aims at that place until the pointer or the keys lead it.
  void begin(const Camera& camera, PointA before, const Workspace& workspace, double outside_A, MouseDevice& mouse);

  /// The orientation, in the molecule's space, with which the hand starts from the next begin() on; empty: that of the
  /// device's axes.
  void startTurned(const std::optional<Quat>& orientation) { start_ = orientation; }

  /// Ends a press as Escape does: it begins again when the button or key has been released.
  void letGo() { let_go_ = true; }

  bool pressing() const { return pressing_; }
  double depth_A() const { return hand_.depth_A(); }
  /// How long the press has rested where it is; 0 without one, and while it slides (unit: second).
  double pressRested_s() const { return press_rested_s_; }
  /// The press meets nothing: where the hand aims there is only empty space.
  bool pressesNothing() const { return pressing_ && !hand_.overSurface(); }
  glm::dvec2 aim_px() const { return hand_.aim_px(); }  ///< the pixel of the view that the hand aims at
  PointA lead() const { return lead_; }
  /// The view was turned, moved or zoomed in the last frame.
  bool cameraMoved() const { return camera_moved_; }
  /// Whether the person has found out how: the hint of controls fades once both are true.
  bool hasPressed() const { return has_pressed_; }
  bool hasTurned() const { return has_turned_; }
  /// A press has been made harder or lighter.
  bool hasPushed() const { return has_pushed_; }
  /// Opacity of the hint of controls: 1 until the person has found out how, then fading to 0.
  double hintStrength() const;
  /// The next frame would look different by itself.
  bool live() const;

 private:
  PointerHand hand_;
  Quat orientation_ = kNoRotation;  // of the hand, from the device's axes
  std::optional<Quat> start_;       // in the molecule's space
  PointA lead_;
  std::optional<PointA> first_aim_;  // of a scene of which no frame has been led
  double hint_left_s_ = 2.0, press_rested_s_ = 0.0;
  bool pressing_ = false, let_go_ = false, camera_moved_ = false;
  bool has_pressed_ = false, has_turned_ = false, has_pushed_ = false;
};

}  // namespace moltact
