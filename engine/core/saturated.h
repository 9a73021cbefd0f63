// Numeric conversions that are defined for every value; a plain cast is undefined if the value does not fit. Any
// thread.
#pragma once

#include <limits>
#include <type_traits>

namespace moltact {

/// `value` rounded toward zero and clamped to the range of `To`; 0 for NaN.
template <class To, class From>
requires(std::is_integral_v<To>&& std::is_floating_point_v<From>) constexpr To saturateToInteger(From value) {
  // The largest value of a wide integer rounds up to a power of two, which does not fit.
  constexpr From kBeyond = From(2) * From(std::numeric_limits<To>::max() / 2 + 1);
  if (!(value == value)) return To(0);
  if (value >= kBeyond) return std::numeric_limits<To>::max();
  if (value <= From(std::numeric_limits<To>::min())) return std::numeric_limits<To>::min();
  return static_cast<To>(value);
}

/// The float nearest to `value`, clamped to the finite range; 0 for NaN.
constexpr float saturateToFloat(double value) {
  constexpr double kMax = double(std::numeric_limits<float>::max());
  if (!(value == value)) return 0.0f;
  return static_cast<float>(value > kMax ? kMax : value < -kMax ? -kMax : value);
}

}  // namespace moltact
