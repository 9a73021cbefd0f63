// A hand made from a mouse or a keyboard: the probe hovers over the surface under the pointer, a press pushes it in.
// Pure logic on the window's thread, once a frame; MouseDevice carries the result smoothly to the haptic thread.
//
// The resistance is shown, not felt: the HIP goes under the surface while the probe stays on it, the push slows down,
// and the pointer's gain falls as the force rises. A held press comes to rest at the depth where the spring gives
// kRest_N; each notch makes that kNotch_N more or less, and the press keeps it. Met at a slant, the surface pushes back
// less than the spring gives at that depth, never more. Units: angstrom, pixel, newton, second.
#pragma once

#include <optional>

#include "engine/core/units.h"
#include "engine/device/view_rays.h"
#include "engine/haptics/ball_scene.h"

namespace moltact {

/// The state of the person's pointing device and keys in one frame.
struct PointerInput {
  ViewRays rays;
  std::optional<glm::dvec2>
      pointer_px;             ///< the pointer's pixel in the view; none: it is elsewhere, or the keyboard leads
  glm::dvec2 keys{0.0};       ///< from the arrow keys: x right, y up, each -1, 0 or 1
  bool press = false;         ///< left button or space bar held
  double push_notches = 0.0;  ///< wheel notches or key presses: positive pushes deeper
  double force_N = 0.0;       ///< the force that the servo loop gave last
  double N_per_A = 1.0;       ///< the force that pushes back per angstrom of depth; 0 where none does
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
  static constexpr double kDeepest_A = 3.0;   ///< the deepest press under the surface
  static constexpr double kHalfGain_N = 1.0;  ///< at this force the pointer moves the probe half as far

  /// The HIP's next target. `probe_A` inflates the scene's balls. Non-finite input leaves the hand where it was.
  PointA lead(const PointerInput& input, const BallScene& scene, double probe_A);

  double depth_A() const {
    return depth_ > 0.0 ? depth_ : 0.0;
  }                                           ///< how far the press has gone under the surface; 0 when hovering
  glm::dvec2 aim_px() const { return aim_; }  ///< the pixel the hand aims at; trails the pointer under force
  /// Forgets where the hand was: at a new scene.
  void reset();

 private:
  void sink(const PointerInput& input, double way_A);

  bool placed_ = false;
  bool pressing_ = false;
  bool aim_follows_ = true;  // false while the keys lead
  glm::dvec2 aim_{0.0}, last_pointer_{0.0};
  double depth_ = 0.0;
  double goal_N_ = kRest_N;   // where the press comes to rest
  double plane_depth_ = 0.0;  // along the view, where the surface was last met
  PointA hip_;
};

}  // namespace moltact
