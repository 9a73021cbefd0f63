// The properties of the touched surface that the servo loop may change while the surface is touched. Each is applied by
// a layer (interactions.h). Plain data; any thread.
#pragma once

namespace moltact {

/// Dry friction between the surface and what the hand holds.
struct Friction {
  double coefficient = 0.0;  ///< of sliding: drag divided by the normal force (0 to kMaxFriction)
  /// By how much more than while sliding a contact at rest holds, as a fraction of `coefficient` (0 to 1). Above 0 a
  /// slow hand sticks and slips in turn.
  double stick_slip = 0.0;

  friend bool operator==(const Friction&, const Friction&) = default;
};

/// The largest coefficient of friction.
inline constexpr double kMaxFriction = 1.0;
/// Largest rate of change of the coefficient while the surface is touched (unit: 1/s). A contact that slips because its
/// friction falls gives up energy; the rate bounds the step of the force.
inline constexpr double kFrictionSlew_per_s = 2.0;

/// All of them. A new one is a member with a neutral default, its line in `surfaceTowards`, and the layer that applies
/// it.
struct SurfaceProperties {
  Friction friction;

  friend bool operator==(const SurfaceProperties&, const SurfaceProperties&) = default;
};

/// The properties `dt_s` after they were `now`, on the way to `goal`: each changes at no more than its rate. Values out
/// of range are clamped; a property with a value that is not finite stays as it is.
SurfaceProperties surfaceTowards(const SurfaceProperties& now, const SurfaceProperties& goal, double dt_s) noexcept;

}  // namespace moltact
