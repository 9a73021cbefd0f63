// A hand made from a mouse or a keyboard: what it holds, the probe or a body, hovers over the surface under the pointer, a
// press pushes it in.
// Pure logic on the window's thread, once a frame; MouseDevice carries the result smoothly to the haptic thread.
//
// The probe stays under the pointer, as far as the surface lets it: the HIP lies on the line of sight through the
// pointer, under the surface while the button is held. A pointer that is fast leads a pressed probe over the surface at
// kFastest_A_per_s, not through what lies between, and a hand that is let go is lifted before it goes anywhere else, so
// that no release strikes. The resistance is shown, not felt: the push slows down as the force rises, and so does a
// probe that the arrow keys lead. A held press comes to rest at the depth where the spring gives
// kRest_N; each notch makes that kNotch_N more or less, and the press keeps it. Met at a slant, the surface pushes back
// less than the spring gives at that depth, never more.
//
// A field (attraction, charge) has no surface. In a well of its energy a press is led: the hand goes down the energy,
// damped, and rests where no force is left; pointer and keys carry it along and out. Elsewhere in a field a press goes
// in until the force that opposes it is the press's own. Units: angstrom, pixel, newton, second.
#pragma once

#include <optional>

#include "engine/core/units.h"
#include "engine/device/view_rays.h"
#include "engine/haptics/body/held_body.h"

namespace moltact {

/// The state of the person's pointing device and keys in one frame.
struct PointerInput {
  ViewRays rays;
  std::optional<glm::dvec2>
      pointer_px;             ///< the pointer's pixel in the view; none: it is elsewhere, or the keyboard leads
  glm::dvec2 keys{0.0};       ///< from the arrow keys: x right, y up, each -1, 0 or 1
  bool press = false;         ///< left button or space bar held
  bool touching = false;      ///< the servo loop's last: the probe touches
  PointA hip;                 ///< the servo loop's last
  double push_notches = 0.0;  ///< wheel notches or key presses: positive pushes deeper
  double force_N = 0.0;       ///< the force that the servo loop gave last
  double N_per_A = 1.0;       ///< the force that pushes back per angstrom of depth; 0 where none does
  bool field = false;         ///< a field acts on the hand, whose force is felt
  Vec3 pull_N{0.0};           ///< the servo loop's last: the force of field and contact, in the molecule's axes
  double well_N_A = 0.0;      ///< the energy of the field there (unit: N A): negative in a well
  double pull_N_per_A = 0.0;  ///< no small step is opposed by more of that force
  double dt_s = 1.0 / 60.0;
};

class PointerHand {
 public:
  static constexpr double kHover_A = 0.35;  ///< how far before the surface the probe waits
  static constexpr double kPressSpeed_A_per_s = 1.2;
  static constexpr double kRest_N = 0.6;       ///< the force at which a held press comes to rest
  static constexpr double kNotch_N = 0.2;      ///< one notch changes that force by this much
  static constexpr double kLightest_N = 0.05;  ///< the lightest press
  static constexpr double kLongestNotch_A =
      0.3;  ///< the most that one notch changes the depth, where the surface hardly pushes back
  static constexpr double kDeepest_A = 3.0;         ///< the deepest press under the surface
  static constexpr double kHalfPace_N = 1.0;        ///< at this force a press sinks, and the keys lead, half as fast
  static constexpr double kFastest_A_per_s = 40.0;  ///< of a pressed probe across the line of sight
  /// To a surface that is nearer by more than this a press goes by no way, and to one that is farther by more it takes
  /// its time: it begins anew there.
  static constexpr double kLeap_A = 5.0, kFall_A_per_s = 20.0;
  /// A well whose force is less than this at the hand and 0.3 A beside it leads no hand.
  static constexpr double kWell_N = 0.05, kWellReach_A = 0.3;
  static constexpr double kSettle_s = 0.15;       ///< time constant of a hand that a well leads
  static constexpr double kLongestLead_A = 0.03;  ///< the most that a well leads it in a 60th of a second
  static constexpr double kLift_s = 0.25;         ///< so long a hand that was let go may take to come free

  /// The HIP's next target for what is held. Non-finite input leaves the hand where it was.
  PointA lead(const PointerInput& input, const SphereGrid& scene, const HandShape& held);

  double depth_A() const {
    return depth_ > 0.0 ? depth_ : 0.0;
  }                                           ///< how far the press has gone under the surface; 0 when hovering
  glm::dvec2 aim_px() const { return aim_; }  ///< the pixel the hand aims at; trails a pointer that is fast
  bool overSurface() const { return met_; }   ///< there is a surface under the pixel it aims at
  /// In the last frame it went to a surface that hides the one before, and waits there: it went by no way.
  bool leapt() const { return leapt_; }
  /// In the last frame a well led the hand.
  bool inWell() const { return in_well_; }
  /// Forgets where the hand was: at a new scene.
  void reset();

 private:
  void aim(const PointerInput& input, double dt_s);
  void sink(const PointerInput& input, double way_A, double opposing_N);
  void followWell(const PointerInput& input, double dt_s);
  PointA meetSurface(const PointerInput& input, const SphereGrid& scene, const HandShape& held);

  bool placed_ = false;
  bool pressing_ = false;
  bool leapt_ = false, met_ = false, in_well_ = false;
  bool aim_follows_ = true;  // false while the keys lead
  glm::dvec2 aim_{0.0}, last_pointer_{0.0};
  double depth_ = 0.0;
  double lift_left_s_ = 0.0;  // of a hand that was let go and may still touch
  double goal_N_ = kRest_N;   // where the press comes to rest
  double plane_depth_ = 0.0;  // along the view, where the surface was last met
  Vec3 over_A_{0.0};          // where the aim met the surface last, or hovered
  PointA hip_;
};

}  // namespace moltact
