// The first ball that a moving point meets: collision in free space (the paper's Algorithm 1, first branch), exact for
// steps of any length. Also used to find the surface under a pointer. Units: angstrom. Safe on the haptic thread.
#pragma once

#include <cstdint>
#include <span>

#include "engine/haptics/ball_scene.h"
#include "engine/haptics/tracker.h"

namespace moltact {

struct Hit {
  std::int32_t ball = -1;   ///< -1: nothing is met
  double t = 1.0;           ///< where on the way from `from` (0) to `to` (1)
};

/// Moves a point from `from` to `to` among the scene's balls inflated by `probe_A`. A ball that the point is in or on
/// already is met at t = 0 when the way leads into it and not at all when it leads out. Balls in `leaving` are passed over.
Hit sweep(const BallScene& scene, double probe_A, const Vec3& from, const Vec3& to,
          std::span<const std::int32_t> leaving = {}) noexcept;

/// A lower bound of the distance from `place` to the nearest inflated ball, exact when under one grid cell;
/// negative or zero inside or on a ball.
double clearance(const BallScene& scene, double probe_A, const Vec3& place) noexcept;

}  // namespace moltact
