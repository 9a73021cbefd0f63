// The angle at which a point on a circular path enters a cap, in closed form. Haptic thread. Units: radian. Along a
// great circle or an intersection circle the point's component along the cap's axis is f(t) = a cos t + b sin t. The
// point's present position is t = 0. q is the component along that axis at the rim of the cap: the point is inside the
// cap where f(t) > q. Precondition: a <= q, so it starts outside.
#pragma once

#include <cmath>

#include "engine/core/units.h"

namespace moltact {

/// The angle of a point that never enters the cap.
inline constexpr double kNever = 1e300;

/// Returns the first t >= 0 at which f rises above q, or kNever.
inline double entryAngle(double a, double b, double q) {
  const double c = std::sqrt(a * a + b * b);
  if (q >= c) return kNever;
  const double t = std::atan2(b, a) - std::acos(std::fmax(q / c, -1.0));
  return t >= 0.0 ? t : t + kTwoPi;
}

/// The entry angles in both directions, from one pair of inverse functions. `forward` equals entryAngle(a, b, q),
/// `backward` equals entryAngle(a, -b, q).
struct Entries {
  double forward = kNever, backward = kNever;
};

inline Entries entryAngles(double a, double b, double q) {
  const double c = std::sqrt(a * a + b * b);
  if (q >= c) return {};
  const double middle = std::atan2(b, a), half = std::acos(std::fmax(q / c, -1.0));
  const auto ahead = [](double entry) { return entry >= 0.0 ? entry : entry + kTwoPi; };
  return {ahead(middle - half), ahead(-middle - half)};
}

}  // namespace moltact
