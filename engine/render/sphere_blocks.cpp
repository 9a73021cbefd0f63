#include "engine/render/sphere_blocks.h"

#include <algorithm>
#include <glm/glm.hpp>
#include <numeric>

namespace moltact {

SphereBlocks::SphereBlocks(std::span<const Sphere> spheres) : order_(spheres.size()) {
  std::iota(order_.begin(), order_.end(), 0u);
  blocks_.reserve(2 * spheres.size() / kMax + 1);
  if (!spheres.empty()) split(spheres, 0, std::uint32_t(spheres.size()));
}

void SphereBlocks::refit(std::span<const Sphere> spheres) {
  for (Block& block : blocks_) block = blockOf(spheres, block.begin, block.end);
}

SphereBlocks::Block SphereBlocks::blockOf(std::span<const Sphere> spheres, std::uint32_t begin,
                                          std::uint32_t end) const {
  Vec3 low = spheres[order_[begin]].centre_A, high = low;
  for (std::uint32_t i = begin; i < end; ++i) {
    low = glm::min(low, spheres[order_[i]].centre_A);
    high = glm::max(high, spheres[order_[i]].centre_A);
  }
  Block block{.centre_A = 0.5 * (low + high), .radius_A = 0.0, .begin = begin, .end = end};
  for (std::uint32_t i = begin; i < end; ++i) {
    const Sphere& b = spheres[order_[i]];
    block.radius_A = std::max(block.radius_A, glm::distance(b.centre_A, block.centre_A) + b.radius_A);
  }
  return block;
}

// Splits across the longest side into halves of equal number.
void SphereBlocks::split(std::span<const Sphere> spheres, std::uint32_t begin, std::uint32_t end) {
  if (end - begin <= kMax) {
    blocks_.push_back(blockOf(spheres, begin, end));
    return;
  }
  Vec3 low = spheres[order_[begin]].centre_A, high = low;
  for (std::uint32_t i = begin; i < end; ++i) {
    low = glm::min(low, spheres[order_[i]].centre_A);
    high = glm::max(high, spheres[order_[i]].centre_A);
  }
  const Vec3 side = high - low;
  const int axis = side.x >= side.y && side.x >= side.z ? 0 : side.y >= side.z ? 1 : 2;
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(
      order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
      [&](std::uint32_t a, std::uint32_t b) { return spheres[a].centre_A[axis] < spheres[b].centre_A[axis]; });
  split(spheres, begin, middle);
  split(spheres, middle, end);
}

}  // namespace moltact
