// Where a point on a circular path enters a cap, in closed form. Haptic thread.
// Along a great circle or an intersection circle the point's share in a cap's axis is f(t) = a cos t + b sin t
// (t = 0 where the point is now); it is covered where f(t) > q. The point itself is not: a <= q. Units: radian.
#pragma once

#include <cmath>

#include "engine/core/units.h"

namespace moltact {

inline constexpr double kNever = 1e300;

/// The first t >= 0 at which f rises above q, or kNever.
inline double entryAngle(double a, double b, double q) {
  const double c = std::sqrt(a * a + b * b);
  if (q >= c) return kNever;
  const double t = std::atan2(b, a) - std::acos(std::fmax(q / c, -1.0));
  return t >= 0.0 ? t : t + kTwoPi;
}

/// The angle to a cap in either direction, from one pair of inverse functions: `forward` as entryAngle(a, b, q) and
/// `backward` as entryAngle(a, -b, q).
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
