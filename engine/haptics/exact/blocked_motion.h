// Which way the SCP may go: the pull toward the HIP, less what the touching balls block. Haptic thread.
// The steepest way down |x - h|^2 that leaves no touching ball is the projection of d = h - s on the cone
// {v : v.n_k >= 0}, n_k the outward normals; at most three of the balls hold it back.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "engine/core/units.h"

namespace moltact {

/// The balls that hold the SCP back, as places in the list of normals given; count 0 to 3.
struct Blocked {
  int count = 0;
  std::array<int, 3> by{-1, -1, -1};
};

/// `normals`: unit, outward. With three, nothing is left of the pull and the point holds.
Blocked blockedMotion(const Vec3& pull, std::span<const Vec3> normals) noexcept;

}  // namespace moltact
