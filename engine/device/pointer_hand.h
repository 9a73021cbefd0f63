// A hand controlled by mouse or keyboard. The probe or body that it holds hovers over the surface under the pointer;
// pressing pushes it in. Pure logic on the window's thread, once per frame; MouseDevice interpolates the result for the
// haptic thread.
//
// The probe stays under the pointer as far as the surface permits. The HIP lies on the line of sight through the
// pointer, under the surface while the button is held. If the pointer is fast, a pressed probe follows over the surface
// at kMaxSpeed_A_per_s and does not pass through obstacles. After a release the hand is lifted before any other motion,
// so that no release causes an impact. While the pointer is on a control over the view, a hovering hand returns to
// where the pointer last stood still over a surface. It is therefore not hidden behind the control.
//
// The resistance is visible instead of felt: pressing slows down as the force rises, and so does a probe moved by the
// arrow keys. A held press comes to rest at the depth where the spring gives kRest_N. Each notch changes this force by
// kNotch_N. On an inclined surface the force is smaller than that of the spring at that depth, never larger.
//
// A field (attraction, charge) has no surface. In an energy well the hand moves down the energy with damping and rests
// where the force vanishes; the pointer and the arrow keys move it sideways, also out of the well; notches move it along
// the line of sight. Elsewhere in a field a press advances until the
// opposing force equals the press's own. Units: angstrom, pixel, newton, second.
#pragma once

#include <optional>

#include "engine/core/units.h"
#include "engine/device/view_rays.h"
#include "engine/haptics/body/held_body.h"

namespace moltact {

/// The state of pointer, keys and servo loop in one frame.
struct PointerInput {
  ViewRays rays;
  std::optional<glm::dvec2>
      pointer_px;             ///< the pointer in the view; empty: outside the view, or the keyboard is in use
  bool over_control = false;  ///< the pointer is on a control that lies over the view
  glm::dvec2 keys{0.0};       ///< arrow keys: x right, y up, each -1, 0 or 1
  bool press = false;         ///< left button or space bar held
  bool touching = false;      ///< newest tick: the probe touches
  PointA hip;                 ///< newest tick
  double push_notches = 0.0;  ///< wheel notches or key presses since the last frame; positive pushes deeper
  double force_N = 0.0;       ///< newest tick: size of the force given
  double N_per_A = 1.0;       ///< opposing force per angstrom of depth; 0: none
  bool field = false;         ///< a field acts on the hand
  Vec3 pull_N{0.0};           ///< newest tick: force of field and contact, in the molecule's axes
  double well_N_A = 0.0;      ///< energy of the field at the hand (unit: N A): negative in a well
  double pull_N_per_A = 0.0;  ///< upper bound of the stiffness of `pull_N`
  double dt_s = 1.0 / 60.0;
};

class PointerHand {
 public:
  static constexpr double kHover_A = 0.35;  ///< distance of a hovering probe from the surface
  static constexpr double kPressSpeed_A_per_s = 1.2;
  static constexpr double kRest_N = 0.6;       ///< force at which a held press comes to rest
  static constexpr double kNotch_N = 0.2;      ///< change of that force per notch
  static constexpr double kMinPress_N = 0.05;  ///< smallest force of a press
  /// Largest change of depth per notch, where the surface hardly resists.
  static constexpr double kMaxNotch_A = 0.3;
  static constexpr double kMaxDepth_A = 3.0;  ///< largest depth of a press under the surface
  static constexpr double kHalfPace_N = 1.0;  ///< force at which pressing and moving by keys have half their speed
  static constexpr double kMaxSpeed_A_per_s = 40.0;  ///< speed limit of a pressed probe across the line of sight
  /// If the surface under the pointer is nearer by more than kLeap_A, the press restarts there. If it is farther by
  /// more than that, the hand advances to it at kFall_A_per_s and the press restarts.
  static constexpr double kLeap_A = 5.0, kFall_A_per_s = 20.0;
  /// A well whose force is below kWell_N at the hand and kWellReach_A beside it does not move the hand.
  static constexpr double kWell_N = 0.05, kWellReach_A = 0.3;
  static constexpr double kSettle_s = 0.15;       ///< time constant of the motion in a well
  static constexpr double kMaxWellStep_A = 0.03;  ///< largest motion in a well per 1/60 s
  static constexpr double kLift_s = 0.25;         ///< longest time for lifting the hand after a release

  /// Returns the HIP's next target for the shape in the hand. Non-finite input leaves the hand unchanged.
  PointA lead(const PointerInput& input, const SphereGrid& scene, const HandShape& held);

  /// Depth of the press under the surface; 0 when hovering.
  double depth_A() const { return depth_ > 0.0 ? depth_ : 0.0; }
  glm::dvec2 aim_px() const { return aim_; }  ///< the pixel at which the hand aims; lags behind a fast pointer
  bool overSurface() const { return met_; }   ///< there is a surface under that pixel
  /// True if in the last frame the hand jumped to a surface in front of the previous one and waits there.
  bool leapt() const { return leapt_; }
  /// True if in the last frame a well moved the hand.
  bool inWell() const { return in_well_; }
  /// Forgets the hand's position, for a new scene.
  void reset();
  /// After reset(): the hand is here and stays until the first press, whatever lies between it and the eye.
  void waitAt(const PointA& place);

 private:
  void aim(const PointerInput& input, double dt_s);
  void sink(const PointerInput& input, double distance_A, double opposing_N);
  void followWell(const PointerInput& input, double dt_s);
  PointA meetSurface(const PointerInput& input, const SphereGrid& scene, const HandShape& held);

  bool placed_ = false;
  bool pressing_ = false;
  bool leapt_ = false, met_ = false, in_well_ = false;
  bool waits_ = false;       // for the first press, at hip_
  bool aim_follows_ = true;  // false while the keys lead
  glm::dvec2 aim_{0.0}, last_pointer_{0.0};
  double depth_ = 0.0;
  double lift_left_s_ = 0.0;     // remaining time of the lift after a release
  double goal_N_ = kRest_N;      // force at which the press comes to rest
  double plane_depth_ = 0.0;     // depth along the view of the last surface
  Vec3 over_A_{0.0};             // where the aim last met the surface, or hovered
  std::optional<Vec3> stood_A_;  // the same where the pointer last stood still over a surface, or pressed
  PointA hip_;
};

}  // namespace moltact
