#include "engine/render/ball_blocks.h"

#include <algorithm>
#include <glm/glm.hpp>
#include <numeric>

namespace moltact {

BallBlocks::BallBlocks(std::span<const Ball> balls) : order_(balls.size()) {
  std::iota(order_.begin(), order_.end(), 0u);
  blocks_.reserve(2 * balls.size() / kMost + 1);
  if (!balls.empty()) split(balls, 0, std::uint32_t(balls.size()));
}

void BallBlocks::refit(std::span<const Ball> balls) {
  for (Block& block : blocks_) block = blockOf(balls, block.begin, block.end);
}

BallBlocks::Block BallBlocks::blockOf(std::span<const Ball> balls, std::uint32_t begin, std::uint32_t end) const {
  Vec3 low = balls[order_[begin]].centre_A, high = low;
  for (std::uint32_t i = begin; i < end; ++i) {
    low = glm::min(low, balls[order_[i]].centre_A);
    high = glm::max(high, balls[order_[i]].centre_A);
  }
  Block block{.centre_A = 0.5 * (low + high), .radius_A = 0.0, .begin = begin, .end = end};
  for (std::uint32_t i = begin; i < end; ++i) {
    const Ball& b = balls[order_[i]];
    block.radius_A = std::max(block.radius_A, glm::distance(b.centre_A, block.centre_A) + b.radius_A);
  }
  return block;
}

// Across the longest side, into halves of equal number.
void BallBlocks::split(std::span<const Ball> balls, std::uint32_t begin, std::uint32_t end) {
  if (end - begin <= kMost) {
    blocks_.push_back(blockOf(balls, begin, end));
    return;
  }
  Vec3 low = balls[order_[begin]].centre_A, high = low;
  for (std::uint32_t i = begin; i < end; ++i) {
    low = glm::min(low, balls[order_[i]].centre_A);
    high = glm::max(high, balls[order_[i]].centre_A);
  }
  const Vec3 side = high - low;
  const int axis = side.x >= side.y && side.x >= side.z ? 0 : side.y >= side.z ? 1 : 2;
  const std::uint32_t middle = begin + (end - begin) / 2;
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](std::uint32_t a, std::uint32_t b) { return balls[a].centre_A[axis] < balls[b].centre_A[axis]; });
  split(balls, begin, middle);
  split(balls, middle, end);
}

}  // namespace moltact
