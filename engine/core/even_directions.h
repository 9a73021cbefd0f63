// Directions spread evenly over the sphere: a Fibonacci lattice.
#pragma once

#include <cmath>
#include <vector>

#include "engine/core/units.h"

namespace moltact {

/// The angle between successive points of a Fibonacci lattice (unit: radian).
inline constexpr double kGoldenAngle_rad = 2.399963229728653;

/// Direction `k` of `count`, of length 1.
inline Vec3 evenDirection(int k, int count) {
  const double z = 1.0 - (2.0 * k + 1.0) / count, r = std::sqrt(1.0 - z * z), turn = kGoldenAngle_rad * k;
  return {r * std::cos(turn), r * std::sin(turn), z};
}

/// All `count` directions.
inline std::vector<Vec3> evenDirections(int count) {
  std::vector<Vec3> out;
  out.reserve(std::size_t(count));
  for (int k = 0; k < count; ++k) out.push_back(evenDirection(k, count));
  return out;
}

}  // namespace moltact
