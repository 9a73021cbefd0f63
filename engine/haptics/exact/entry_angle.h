// Where a point on a circular way first enters a cap, in closed form. Haptic thread.
// Along a great circle or an intersection circle the point's share in a cap's axis is f(t) = a cos t + b sin t
// (t = 0 where the point is now); it is covered where f(t) > q. Units: radian.
#pragma once

#include <cmath>

namespace moltact {

inline constexpr double kNever = 1e300;
inline constexpr double kTurn = 6.283185307179586476925;

/// The first t >= 0 at which f rises above q, or kNever. `on_rim`: the point is known to lie on the rim (f(0) = q but
/// for rounding), so that only the sign of b tells whether it enters now or leaves and may come back much later.
inline double entryAngle(double a, double b, double q, bool on_rim) {
  const double c = std::sqrt(a * a + b * b);
  if (q >= c || q < -c) return kNever;  // never covered; or covered all round, which on a free way is rounding
  if ((on_rim || a >= q) && b > 0.0) return 0.0;
  const double t = std::atan2(b, a) - std::acos(q / c);
  if (on_rim || a >= q) return t > 0.0 ? t : t + kTurn;
  return t >= 0.0 ? t : t + kTurn;
}

/// The way to a cap in either direction, from one pair of inverse functions: `forward` as entryAngle(a, b, …) and
/// `backward` as entryAngle(a, -b, …).
struct Entries {
  double forward = kNever, backward = kNever;
};

inline Entries entryAngles(double a, double b, double q, bool on_rim) {
  const double c = std::sqrt(a * a + b * b);
  if (q >= c || q < -c) return {};
  const double middle = std::atan2(b, a), half = std::acos(q / c);
  const bool rim = on_rim || a >= q;
  const auto ahead = [&](double towards, double entry) {
    if (rim && towards > 0.0) return 0.0;
    return (rim ? entry > 0.0 : entry >= 0.0) ? entry : entry + kTurn;
  };
  return {ahead(b, middle - half), ahead(-b, -middle - half)};
}

}  // namespace moltact
